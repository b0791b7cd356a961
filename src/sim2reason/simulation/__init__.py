"""From a mechanism to a certified trace: two engines, events, truncation, certificate."""
