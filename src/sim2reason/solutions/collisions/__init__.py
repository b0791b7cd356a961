"""Flights between collisions, the impacts themselves, and what adds up over both."""
