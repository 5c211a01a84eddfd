"""Claims of Section V: the discussion."""
