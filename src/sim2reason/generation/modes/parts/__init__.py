"""What modes share."""
