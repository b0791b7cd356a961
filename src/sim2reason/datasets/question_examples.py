"""An example of everything that can be asked, in words and in parts, found in scenes that the recipes draw."""

from collections.abc import Iterator
from dataclasses import dataclass, field
from typing import cast

import numpy as np

from sim2reason.datasets.random_scenes import random_scenes
from sim2reason.dsl.scene import Scene
from sim2reason.errors import TextError
from sim2reason.prose.description import describe
from sim2reason.questions import KINDS, MOMENTS, Query, Words
from sim2reason.questions.following import FollowedMotion, motion_of
from sim2reason.questions.functionals import FUNCTIONALS
from sim2reason.questions.kinds import by_share
from sim2reason.questions.kinds.parts.stretch_kind import StretchQuery
from sim2reason.questions.kinds.threshold import ThresholdQuery
from sim2reason.questions.moments import Happening, Moment
from sim2reason.questions.period_words import PeriodQuery
from sim2reason.questions.posing import PosedQuestion, posed
from sim2reason.questions.prompt import words_of
from sim2reason.questions.structured import START, StructuredQuestion, moment_told
from sim2reason.questions.targets import targets
"""E"""
