"""Simulation of mechanisms with changing equations, or with constraints that MuJoCo itself cannot represent."""
