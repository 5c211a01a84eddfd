"""Formulas and the prose about them, for each kind of reader: MathML, LaTeX, Unicode; and the font of the page's."""
