"""Solutions of problems with several parts: one name for each quantity, and earlier results quoted."""
