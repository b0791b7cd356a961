"""Tests of recipes, difficulties and modes as chosen by settings in a file."""

import pytest
from pydantic import ValidationError

from sim2reason.datasets.plan import Chosen


@pytest.mark.parametrize("given", ["all", "numeric", ("numeric", "reverse")])
def test_one_several_or_all(given: str | tuple[str, ...]) -> None:
    assert Chosen(modes=given).modes == given


@pytest.mark.parametrize("name", Chosen.model_fields)
@pytest.mark.parametrize(("given", "message"), [("hardd", "no such"), (("puley",), "no such"), ([], "names none")])
def test_what_is_unknown_or_nothing_is_refused(name: str, given: object, message: str) -> None:
    with pytest.raises(ValidationError, match=message):
        Chosen.model_validate({name: given})
