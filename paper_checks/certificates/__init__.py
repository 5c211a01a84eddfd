"""Certificates: what a search has found, written down as exact rationals, and a checker that shares no code with it."""
