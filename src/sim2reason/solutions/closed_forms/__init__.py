"""Closed forms: the answer of a worked solution as one formula of the numbers that the text and the question say."""

from sim2reason.solutions.closed_forms.closed_form import (
    LONGEST,
    ClosedForm,
    ClosedFormError,
    closed_form,
    put_together,
    shortened,
)

__all__ = ["LONGEST", "ClosedForm", "ClosedFormError", "closed_form", "put_together", "shortened"]
