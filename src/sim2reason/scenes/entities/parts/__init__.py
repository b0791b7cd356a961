"""Parts that several entities share."""
