"""Claims of Section II: the model."""
