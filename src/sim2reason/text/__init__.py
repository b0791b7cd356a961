"""Text: scenes and questions rendered as English prose, and prose parsed into scenes."""
