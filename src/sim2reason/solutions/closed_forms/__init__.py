"""Closed forms: the answer of a worked solution as one formula of the numbers that the text and the question say."""

from sim2reason.solutions.closed_forms.closed_form import ClosedForm, ClosedFormError, closed_form

__all__ = ["ClosedForm", "ClosedFormError", "closed_form"]
