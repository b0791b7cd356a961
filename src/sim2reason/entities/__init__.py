"""The entities that scenes are made of, one file each."""
