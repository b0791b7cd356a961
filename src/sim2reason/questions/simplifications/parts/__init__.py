"""What several simplifications share."""
