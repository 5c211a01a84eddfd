"""Claims of the abstract and of Section I."""
