"""Theorems past the paper, and what claims share with them."""
