"""Stable equilibria of mechanisms, small oscillations about them, and their check by the second engine."""
