"""The checks, one module for each section of the paper, and the registry of which check decides which claim."""
