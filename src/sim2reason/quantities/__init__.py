"""What can be recorded and asked of a motion, each a function of the state alone."""
