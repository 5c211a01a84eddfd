"""Claims of Section IV: the case study."""
