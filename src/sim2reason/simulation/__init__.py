"""Simulation of mechanisms: two independent engines, traces with events, and the certificate of their agreement."""
