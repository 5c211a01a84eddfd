"""Where a motion ends: the first root, certified."""
