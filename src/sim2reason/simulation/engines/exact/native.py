"""The choice between the native core and the Python that it replaces, made once, when this module is imported.

The native core is an extension module, compiled from the folder `core` when the package is installed where a C compiler
is found. It has the tape and its programs, the integration of one contact mode with the location of its events, samples
of a motion, and the forces of a contact mode. Results are the same bit for bit. The environment variable
``SIM2REASON_NATIVE=0`` selects Python.
"""

import os

from sim2reason.simulation.engines.exact.dop853_table import DENSE, ERROR_3, ERROR_5, NODES, STAGES

SWITCH = "SIM2REASON_NATIVE"  # environment variable; 0 selects Python
CORE_API_VERSION = 2  # the same as in core/dop853.c; an extension left by an earlier version is not used

core = None
if os.environ.get(SWITCH) != "0":
    try:
        from sim2reason.simulation.engines.exact.core import _core as core

        core.set_up(CORE_API_VERSION, NODES, STAGES, ERROR_5, ERROR_3, DENSE)
    except ImportError:  # installed without a compiler, or of another API
        core = None


def uses_native_core() -> bool:
    """Return whether the native core is in use, rather than the Python that it replaces.

    Returns:
        Whether the extension module was compiled at installation and is not switched off.

    Examples:
        >>> from sim2reason.simulation.engines.exact import uses_native_core
        >>> uses_native_core() in (True, False)
        True
    """
    return core is not None
