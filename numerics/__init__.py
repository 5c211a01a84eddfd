"""What happens: trajectories of the inertial pair as numbers with a stated error."""
