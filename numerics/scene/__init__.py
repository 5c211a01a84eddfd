"""What is given: the pair, its initial state, force and friction in time, the reading of the law; scene files."""

from numerics.scene.friction import Friction, Weakening
from numerics.scene.model import Law, Pair, Scene, State, read_law
from numerics.scene.pieces import Force, Piece, Signal, Sine

__all__ = ["Force", "Friction", "Law", "Pair", "Piece", "Scene", "Signal", "Sine", "State", "Weakening", "read_law"]
