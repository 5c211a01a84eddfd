"""Claims of Section III: the free pair."""
