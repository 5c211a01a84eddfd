"""What is said, what was checked, and what was found: the data that checks make and the report shows."""
