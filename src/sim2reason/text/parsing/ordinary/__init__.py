"""Parsing of ordinary English: replacement of sentences by equivalent sentences of the library."""
