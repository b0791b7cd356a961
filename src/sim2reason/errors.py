"""Every error that the library raises on purpose.

    Sim2ReasonError
    ├── SceneError          a scene, or a file of one, that says something impossible or unknown
    │   └── TextError       a text that means no scene, or more than one
    ├── UnsupportedError    a mechanism that an engine has no model for
    ├── SimulationError     an engine that could not go on from a valid mechanism
    ├── DrawError           a recipe that found no valid draw within its budget
    ├── DatasetError        a dataset folder that is damaged or belongs to another configuration
    ├── PolicyError         a model that cannot be asked, or that gave no answer
    ├── EvaluationError     a configuration, benchmark file or run folder of an evaluation that cannot be used
    ├── TrainingError       a configuration, corpus or folder of a training run that cannot be used
    ├── UnknownNameError    a name that a registry does not hold
    ├── MissingExtraError   an optional package that a command needs
    ├── EntryPointError     an installed package that extends the library and cannot be imported
    └── ConformanceError    an entity class that does not keep what the library promises of entities

Two warnings, which are no errors: a `FigureWarning` says that a figure can only hint at something, a
`MotionEndsWarning` that a motion could not be followed for as long as was asked.

A message names the place and the remedy in one line; the command line prints it and exits with 2.
"""

import re
from shlex import quote


class Sim2ReasonError(Exception):
    """The base class of all errors that the library raises on purpose.

    The message is one line that names the place and the remedy. The command line prints it and exits with code 2.

    Examples:
        >>> import sim2reason
        >>> try:
        ...     sim2reason.item("pully")
        ... except sim2reason.Sim2ReasonError as error:
        ...     print(error)
        no such name among recipes: 'pully'; did you mean: pulley
    """


class SceneError(Sim2ReasonError):
    """A scene that cannot be: `place` is the path inside the file or scene, `remedy` what to do."""

    def __init__(self, place: str, problem: str, remedy: str = "") -> None:
        """Keep the three parts; the message joins them as ``place: problem; remedy``."""
        self.place, self.problem, self.remedy = place, problem, remedy
        super().__init__(f"{place}: {problem}" + (f"; {remedy}" if remedy else ""))

    def __reduce__(self) -> "tuple[type[SceneError], tuple[str, str, str]]":
        """Pickle the three parts, so that a worker process can send it."""
        return type(self), (self.place, self.problem, self.remedy)


class TextError(SceneError):
    """A problem text that no scene, or more than one, would have produced."""


class UnsupportedError(Sim2ReasonError):
    """A mechanism outside what an engine models, for example a rough body that slides in two directions."""


class SimulationError(Sim2ReasonError):
    """An engine that found no consistent motion, or ran out of its budget of steps."""

    def __init__(self, message: str, reached: float = 0.0) -> None:
        """Store the message and the time `reached` (s) to which the motion was found; 0 if unknown or never begun."""
        self.reached = reached
        super().__init__(message)


class DrawError(Sim2ReasonError):
    """A recipe whose draws were all refused within the budget, or that was asked for at impossible coordinates."""


class FigureWarning(UserWarning):
    """Something in a scene that a figure can only hint at, since its class does not say how it looks."""


class MotionEndsWarning(UserWarning):
    """A recorded motion that is shorter than requested, since the description of the motion ends earlier."""


class DatasetError(Sim2ReasonError):
    """A dataset folder that is damaged, incomplete or made with another configuration."""


class PolicyError(Sim2ReasonError):
    """A model that cannot be asked, or that gave no answer; the message never holds a key."""


class EvaluationError(Sim2ReasonError):
    """A configuration, a benchmark's file or the folder of a run that cannot be used for an evaluation."""


class TrainingError(Sim2ReasonError):
    """A configuration, a corpus or the folder of a run that cannot be used for training."""


class UnknownNameError(Sim2ReasonError, KeyError):
    """A name that a registry does not hold; the message lists the nearest known ones."""

    def __str__(self) -> str:
        """KeyError would show the message in quotes."""
        return str(self.args[0])


class MissingExtraError(Sim2ReasonError):
    """An optional package is missing; the message says what to install."""

    def __init__(self, package: str, extra: str = "") -> None:
        """Name the missing `package` and the `extra` that brings it, if one does."""
        remedy = f", or in a clone: pip install '.[{extra}]'" if extra else ""
        super().__init__(f"{package} is not installed; install it with: {installing(package, extra)}{remedy}")


class EntryPointError(Sim2ReasonError):
    """An entry point of an installed package that cannot be imported; the message names the package and the cause."""


def installing(package: str, extra: str = "") -> str:
    """Return the pip command that installs a package, or all packages of the extra that the package belongs to.

    The command lists the packages by name: sim2reason is on no index, so that its name there may be anyone's.
    """
    from importlib.metadata import PackageNotFoundError, requires  # noqa: PLC0415 - it takes as long as all else

    mark = re.compile(rf"""\bextra\s*==\s*["']{re.escape(extra)}["']""")
    try:
        needed = [each.partition(";") for each in requires("sim2reason") or ()]
    except PackageNotFoundError:  # it runs from its source
        needed = []
    names = [name.strip() for name, _, condition in needed if extra and mark.search(condition)]
    return f"pip install {' '.join(map(quote, names or [package]))}"


class ConformanceError(Sim2ReasonError, AssertionError):
    """What the conformance kit found; the message tells every finding, in words. A test shows it as a failure."""
