"""Theorems that a proof kernel has accepted: the proof files, compiling them, and what each theorem says and rests on."""
