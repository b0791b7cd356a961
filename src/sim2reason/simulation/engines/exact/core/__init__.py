"""The native core of the exact engine: its sources in C, and the extension module `_core` where it is compiled."""
