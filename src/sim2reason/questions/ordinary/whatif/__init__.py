"""Questions in ordinary English about a changed scene: with other numbers, or with a number that makes something so."""
