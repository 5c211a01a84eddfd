"""Other integrators, behind one interface: the paper's forward Euler first."""
