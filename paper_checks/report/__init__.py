"""The ledger joined to its evidence, for a reader: terminal, JSON, HTML and LaTeX."""
