"""Generation of problems: recipes, question modes, quality filters and the search for an item."""
