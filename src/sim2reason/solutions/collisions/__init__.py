"""Free flights between collisions, the collisions, and sums over both."""
