"""The command `report`, and what takes long in it: chapters and figures, made in processes as rows are."""
