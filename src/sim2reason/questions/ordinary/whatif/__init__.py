"""Questions in ordinary English about a changed scene, or for a number that brings something about."""
