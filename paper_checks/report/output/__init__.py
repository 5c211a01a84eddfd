"""The files of a report: its figures, and the whole, made once and kept in the user's cache."""
