"""How the report is written: HTML, LaTeX, also for the PDF, JSON, the terminal; and figures as vector graphics."""
