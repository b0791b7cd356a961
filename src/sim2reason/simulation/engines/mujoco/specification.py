"""The MjSpec description of a mechanism: bodies, joints and sites, without MuJoCo's own constraints.

Bodies move by slide and hinge joints. A body on a face has an additional slide joint along the face's normal, which
its contact keeps closed.
"""

from collections.abc import Generator, Sequence
from contextlib import contextmanager
from importlib import import_module
from typing import Any, TypeAlias

from sim2reason.errors import SimulationError
from sim2reason.scenes.dsl.mechanism import Mechanism, RigidBody

mujoco: Any = import_module("mujoco")  # it ships no types; seen by few modules of this package
Element: TypeAlias = Any  # part of a specification: a body, a joint, a site

SUBSTITUTE_MASS = 1e-9  # kg or kg m²; substitute mass of a massless moving body, since MuJoCo divides by mass
INERTIA_PADDING = (
    1e-10  # fraction of a body's largest moment of inertia, added to all three, as MuJoCo checks A + B ≥ C exactly
)


@contextmanager
def collect_warnings() -> Generator[list[str], None, None]:
    """Collect MuJoCo's warnings in a list, which otherwise go to a file in the working directory."""
    warnings: list[str] = []
    before = mujoco.get_mju_user_warning()
    mujoco.set_mju_user_warning(warnings.append)
    try:
        yield warnings
    finally:
        mujoco.set_mju_user_warning(before)


class Specification:
    """The MjSpec description under construction; parts have numbers as names, since any text may be a name."""

    def __init__(self, mechanism: Mechanism) -> None:
        """Describe all bodies, joints and sites of a mechanism."""
        self._mechanism = mechanism
        self.spec: Any = mujoco.MjSpec()
        self.bodies: dict[str, Element] = {}
        self.joints: dict[str, Element] = {}
        self.faces: dict[str, Element] = {}
        self.sites: dict[str, Element] = {}
        self.spec.option.gravity = mechanism.gravity
        off = mujoco.mjtDisableBit
        self.spec.option.disableflags |= int(off.mjDSBL_CONSTRAINT) | int(off.mjDSBL_CONTACT)
        for body in mechanism.bodies:
            self._body(body)
        for site in mechanism.sites:
            carrier = self.spec.worldbody if site.body is None else self.bodies[site.body]
            self.sites[site.name] = carrier.add_site(name=f"s{len(self.sites)}", pos=site.at)

    def compile(self) -> tuple[Any, Any]:
        """Return MuJoCo's model and data; raise SimulationError if MuJoCo rejects the description."""
        try:
            model = self.spec.compile()
        except ValueError as error:
            raise SimulationError(f"MuJoCo does not compile this mechanism: {error}") from error
        return model, mujoco.MjData(model)

    def _body(self, body: RigidBody) -> None:
        carrier = self.spec.worldbody if body.parent is None else self.bodies[body.parent]
        made = self.bodies[body.name] = carrier.add_body(pos=body.at)
        made.explicitinertial = True
        made.mass, made.ipos = max(body.mass, SUBSTITUTE_MASS if body.coordinates else 0.0), body.center
        made.gravcomp = float(body.mass == 0.0)  # the substitute mass has no weight
        more = max(INERTIA_PADDING * max(body.inertia[:3]), SUBSTITUTE_MASS * 1e-3)
        made.fullinertia = [*(part + more for part in body.inertia[:3]), *body.inertia[3:]]
        face = self._mechanism.contacts.get(body.name)
        if face is not None and not face.turning:
            self.faces[body.name] = self._joint(made, "slide", face.normal)
        for coordinate in body.coordinates:
            self.joints[coordinate.name] = self._joint(made, coordinate.kind, coordinate.axis)
        if face is not None and face.turning:
            self.faces[body.name] = self._joint(made, "slide", face.normal)

    def _joint(self, body: Element, kind: str, axis: Sequence[float]) -> Element:
        types = {"slide": mujoco.mjtJoint.mjJNT_SLIDE, "hinge": mujoco.mjtJoint.mjJNT_HINGE}
        return body.add_joint(name=f"j{len(self.joints) + len(self.faces)}", type=types[kind], axis=axis, limited=0)
