"""Whether worked solutions are sound: by what they are made of, and by their text alone."""
