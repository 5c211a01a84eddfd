"""What a control engineer asks of the pair: thresholds, periodic responses, references, transfers, tolerance rings."""
