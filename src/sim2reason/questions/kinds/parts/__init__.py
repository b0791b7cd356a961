"""What several kinds of question share."""
