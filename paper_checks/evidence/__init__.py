"""What is said, what was checked, and what was found: the data that claims are made of and the report shows."""
