"""What is true: the model of the inertial pair as sympy expressions, derived and never typed in."""
