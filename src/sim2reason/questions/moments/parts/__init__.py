"""What several moments share."""
