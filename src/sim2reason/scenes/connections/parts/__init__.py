"""What several connections share."""
