"""Closed forms of each mode: the undamped slip, the damped oscillator."""
