"""The paper's own pair (a1 = 0, no force, b constant): its engine, long time, who merges from where."""
