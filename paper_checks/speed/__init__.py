"""Speed and accuracy: a recorded trade read for advice, and what forward Euler makes of the paper's figures."""
