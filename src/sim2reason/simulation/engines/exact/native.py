"""The choice between the native core and the Python that it replaces, made once, when this module is imported.

The native core is an extension module, compiled from the folder `core` when the package is installed where a C compiler
is found. It has the tape and its programs, the integration of one contact mode with the location of its events, samples
of a motion, and the solution of small linear systems. Results are the same bit for bit. The environment variable
``SIM2REASON_NATIVE=0`` selects Python.
"""

import os

from sim2reason.simulation.engines.exact.dop853_table import DENSE, ERROR_3, ERROR_5, NODES, STAGES

SWITCH = "SIM2REASON_NATIVE"  # environment variable; 0 selects Python

core = None
if os.environ.get(SWITCH) != "0":
    try:
        from sim2reason.simulation.engines.exact.core import _core as core
    except ImportError:  # installed without a compiler
        core = None
    else:
        core.set_coefficients(NODES, STAGES, ERROR_5, ERROR_3, DENSE)


def uses_native_core() -> bool:
    """Return whether the native core is in use, rather than the Python that it replaces."""
    return core is not None
