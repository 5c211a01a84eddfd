"""What is given: the pair, its initial state, force and friction in time, the reading of the law; scene files."""

from numerics.scene.model import Law, Pair, Scene, State, read_law
from numerics.scene.pieces import Force, Friction, Piece, Sine, Weakening

__all__ = ["Force", "Friction", "Law", "Pair", "Piece", "Scene", "Sine", "State", "Weakening", "read_law"]
