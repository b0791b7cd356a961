"""Parts shared by several entities."""
