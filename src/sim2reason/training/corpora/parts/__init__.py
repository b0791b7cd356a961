"""What corpora share: how files of rows are read, how corpora are mixed, and how rows become tokens."""
