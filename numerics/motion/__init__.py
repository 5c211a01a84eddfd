"""Stick, slip, start: which mode follows, and in which coordinates."""
