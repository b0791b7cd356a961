"""Texts in ordinary English: the library's own sentences that say the same, or those that come nearest."""
