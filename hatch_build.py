"""Compilation of the native core of the exact engine while a wheel is built, where a C compiler is found.

Without one, or if compilation fails, the wheel is pure Python, and the engine uses the Python that the core replaces.
The environment variable ``SIM2REASON_BUILD_NATIVE`` may be ``0`` (do not compile) or ``1`` (fail if that fails).
"""

import os
import shutil
import sys
import tempfile
from pathlib import Path
from typing import Any

from hatchling.builders.hooks.plugin.interface import BuildHookInterface

CORE = "sim2reason/simulation/engines/exact/core"
SWITCH = "SIM2REASON_BUILD_NATIVE"
# Without contraction to fused operations and without the compiler's own versions of libm, results are those of Python.
FLAGS = ["-std=c99", "-O2", "-fno-fast-math", "-ffp-contract=off", "-fno-builtin", "-fvisibility=hidden", "-g0"]


class NativeCoreHook(BuildHookInterface[Any]):
    """The hook by which hatchling compiles the native core and adds it to a wheel."""

    _scratch: Path | None = None

    def initialize(self, version: str, build_data: dict[str, Any]) -> None:
        """Compile the core; an editable install gets it in the source tree, from which the package is imported."""
        if self.target_name != "wheel" or os.environ.get(SWITCH) == "0":
            return
        sources = Path(self.root, "src", CORE)
        scratch = self._scratch = Path(tempfile.mkdtemp())
        try:
            built = compiled(sources, sources if version == "editable" else scratch / "built", scratch)
        except (Exception, SystemExit) as error:  # setuptools has errors of many kinds
            if os.environ.get(SWITCH) == "1":
                raise
            self.app.display_warning(f"the native core is left out: {error}")
            return
        build_data["pure_python"] = False
        build_data["infer_tag"] = True
        if version != "editable":
            build_data["force_include"][str(built)] = f"{CORE}/{built.name}"

    def finalize(self, version: str, build_data: dict[str, Any], artifact_path: str) -> None:
        """Remove what the compiler left."""
        del version, build_data, artifact_path
        if self._scratch is not None:
            shutil.rmtree(self._scratch, ignore_errors=True)


def compiled(sources: Path, folder: Path, scratch: Path) -> Path:
    """Compile the sources to an extension module in a folder and return its path; raise if that is not possible."""
    if sys.platform == "win32" or sys.implementation.name != "cpython":
        raise RuntimeError("it is for CPython and for compilers with the options of GCC")
    from setuptools import Distribution, Extension  # noqa: PLC0415 - a requirement of this build alone

    names = sorted(str(path) for path in sources.glob("*.c"))
    extension = Extension("_core", names, extra_compile_args=FLAGS, libraries=["m"])
    command = Distribution({"name": "core", "ext_modules": [extension]}).get_command_obj("build_ext")
    command.build_lib, command.build_temp = str(folder), str(scratch)
    command.ensure_finalized()
    command.run()
    return Path(command.get_ext_fullpath("_core"))
