"""Solutions of multipart problems, with one name for each quantity and references to earlier results."""
