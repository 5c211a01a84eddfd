"""Derivatives of events and ends by initial state and parameters, across events."""
