"""All ways to a yes: an identity, two solvers, balls, a point, the kernel."""
