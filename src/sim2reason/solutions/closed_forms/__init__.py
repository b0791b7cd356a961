"""Closed forms: the answer of a worked solution as one formula of the given quantities."""

from sim2reason.solutions.closed_forms.closed_form import (
    MAX_LATEX_LENGTH,
    ClosedForm,
    ClosedFormError,
    closed_form,
    combined_formula,
    simplified_form,
)

__all__ = ["MAX_LATEX_LENGTH", "ClosedForm", "ClosedFormError", "closed_form", "combined_formula", "simplified_form"]
