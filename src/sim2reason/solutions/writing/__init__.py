"""From a derivation to its text: names, units, steps and sentences."""
