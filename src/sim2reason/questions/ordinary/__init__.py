"""Questions in ordinary English, read as questions in parts."""
