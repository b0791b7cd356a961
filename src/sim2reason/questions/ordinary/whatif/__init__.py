"""Questions in ordinary English about a changed scene, or for a number that causes a given result."""
