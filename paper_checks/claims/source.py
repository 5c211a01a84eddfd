"""The paper that was checked: who wrote it, which text of it, and how to tell whether a file is that text."""

import hashlib
from pathlib import Path

TITLE = "Dynamics of inertial pair coupled via frictional interface"
AUTHORS = ("Michael Ruderman", "Andrei Zagvozdkin", "Dmitrii Rachinskii")
FILE = "dynamics-of-inertial-pair.tex"
SHA256 = "6e9b53be8788386a3f8a595875e08adfec5432c234ad5e1edf5749c156ee8d81"
"""Of the LaTeX source whose sentences the ledger quotes."""
VERSION = "the source carries no date and no version; its hash is what identifies it"
ARXIV = "2202.13913"
YEAR = f"20{ARXIV[:2]}"
"""Of the preprint: its identifier begins with year and month."""
PREPRINT = f"arXiv:{ARXIV} has this title and these authors; whether its text is the one checked here is not known"
DOI = "none known"


def is_the_source(path: Path) -> bool:
    """Return whether a file is, byte for byte, the text that was checked; raises OSError."""
    return hashlib.sha256(path.read_bytes()).hexdigest() == SHA256
