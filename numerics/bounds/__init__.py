"""What rounding can have done: bounds carried from event to event beside the numbers, in float64 and double-double."""
