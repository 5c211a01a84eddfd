"""How the report's figures are drawn: exact trajectories sampled for the eye, beside forward Euler."""
