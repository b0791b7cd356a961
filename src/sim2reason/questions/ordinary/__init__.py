"""Questions in ordinary English, read as structured questions."""
