"""python -m numerics audit: what this package claims of its own numbers, measured."""
