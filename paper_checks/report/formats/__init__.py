"""How the report is written: HTML, LaTeX, also for the PDF, Markdown, JSON, the terminal; and figures as vector graphics."""
