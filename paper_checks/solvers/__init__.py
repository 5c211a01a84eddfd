"""Polynomial statements over the reals, proved by SMT solvers."""
