"""What decides a statement, and answers with evidence: algebra, balls, one point, samples, the proof kernel."""
