"""What the paper says, and what was found: the ledger of claims, their checks and the report."""
