"""Speed against accuracy, measured: our arithmetics and other people's integrators on the same scenes, in one run."""
