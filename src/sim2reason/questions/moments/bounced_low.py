"""The bounce after which a body never again rises to a stated height."""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from typing import Self
