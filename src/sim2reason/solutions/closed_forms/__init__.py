"""Closed forms: the answer of a worked solution as one formula of the given quantities."""

from sim2reason.solutions.closed_forms.closed_form import (
    LONGEST,
    ClosedForm,
    ClosedFormError,
    closed_form,
    put_together,
    shortened,
)

__all__ = ["LONGEST", "ClosedForm", "ClosedFormError", "closed_form", "put_together", "shortened"]
