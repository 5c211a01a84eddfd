"""How the report is written: HTML, LaTeX, typst for PDF, Markdown, JSON, the terminal; and figures as vector graphics."""
