"""Three arithmetics behind one small protocol: float64, mpmath, and python-flint balls."""
