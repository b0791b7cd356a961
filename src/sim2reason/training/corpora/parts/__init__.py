"""What corpora share: how files of rows are read and mixed, how rows become tokens, how solutions become arithmetic."""
