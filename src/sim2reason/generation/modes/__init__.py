"""The modes of questions, one file each."""
