"""Phases of a motion: the equations of each, the events between them, and the values at its end."""
