"""The files of a report: its figures and forms, made once and kept in the user's cache."""
