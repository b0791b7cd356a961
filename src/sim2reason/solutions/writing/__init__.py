"""The text of worked solutions: names, units, steps and sentences."""
