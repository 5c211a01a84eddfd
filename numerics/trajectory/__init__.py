"""The answer: segments, events, dense evaluation, ledger, export; it knows no solver."""
