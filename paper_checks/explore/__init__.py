"""The interactive page: phase space, itinerary and energy of the pair, solved in the reader's browser."""
