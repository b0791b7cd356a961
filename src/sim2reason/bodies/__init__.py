"""The bodies that entities are made of, one file each."""
