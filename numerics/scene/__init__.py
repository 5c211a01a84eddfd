"""What is given: the pair, its initial state, the reading of the law, exact decimals, scene files."""

from numerics.scene.model import Law, Pair, Scene, State, read_law

__all__ = ["Law", "Pair", "Scene", "State", "read_law"]
