"""How the report is written: HTML, JSON, the terminal; and figures as vector graphics."""
