"""Grading: numbers, formulas, choices and answers of several parts, without executing any text of the response."""

from sim2reason.grading.choice import choice
from sim2reason.grading.extract import opened
from sim2reason.grading.formula import FormulaError, formula
from sim2reason.grading.number import number
from sim2reason.grading.parts import parts
from sim2reason.grading.score import Outcome, Score

__all__ = ["FormulaError", "Outcome", "Score", "choice", "formula", "number", "opened", "parts"]
