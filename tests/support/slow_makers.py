"""Maker whose module takes longer to import than a batch may take."""

import time

from fake_makers import steady

__all__ = ["steady"]
time.sleep(1.5)
