"""Theorems that a proof kernel has accepted: the proof files, compiling them, and what each theorem says and rests on.

>>> from paper_checks.proofs import theorem
>>> theorem("contraction").name
'Pair.contraction'
"""

from paper_checks.proofs.library import Built, Proved, build, theorem

__all__ = ["Built", "Proved", "build", "theorem"]
