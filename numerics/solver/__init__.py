"""Choose the arithmetic that the asked digits need, and solve."""
