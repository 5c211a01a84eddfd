"""The engine: modes that are linear, z' = A z, their guards, and the first roots of these."""
