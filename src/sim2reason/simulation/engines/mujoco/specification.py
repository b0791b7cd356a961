"""The MjSpec description of a mechanism.

Bodies move by slide and hinge joints. Each string is a tendon with an upper limit: through its sites, or, if
it turns massive pulleys, a sum of joint positions whose coefficients are filled in later. A body on a face has
one more slide joint, along the face's normal, with a lower limit: the limit's force is the normal force.
Friction is the joint's `frictionloss`, or an equality while the body sticks. A pull is a motor on a tendon.
Each pair that may collide has a tendon of joint positions, which acts in impacts alone.
"""

from collections.abc import Generator
from contextlib import contextmanager
from importlib import import_module
from typing import Any, Literal, TypeAlias

from sim2reason.errors import SimulationError
from sim2reason.scenes.dsl.mechanism import ConstantTension, Line, Mechanism, RigidBody

mujoco: Any = import_module("mujoco")  # it ships no types; seen by few modules of this package
Element: TypeAlias = Any  # part of a specification: a body, a joint, a site, a tendon

STEP = 0.2  # s; motion between events is quadratic, which RK4 integrates exactly
TINY = 1e-9  # kg or kg m²; substitute mass of a massless moving body, since MuJoCo divides by mass
IMPEDANCE = 0.9999  # the largest value that MuJoCo admits
FAR = 1e6  # m; a limit that is never reached


@contextmanager
def collect_warnings() -> Generator[list[str], None, None]:
    """Collect MuJoCo's warnings in a list, which otherwise go to a file in the working directory."""
    said: list[str] = []
    before = mujoco.get_mju_user_warning()
    mujoco.set_mju_user_warning(said.append)
    try:
        yield said
    finally:
        mujoco.set_mju_user_warning(before)


class Specification:
    """The MjSpec description under construction; parts are named by numbers, since any text may be a name."""

    def __init__(self, mechanism: Mechanism) -> None:
        """Describe all bodies, joints, sites and tendons of a mechanism."""
        self.spec: Any = mujoco.MjSpec()
        self.bodies: dict[str, Element] = {}
        self.joints: dict[str, Element] = {}
        self.faces: dict[str, Element] = {}
        self.sites: dict[str, Element] = {}
        self.paths: list[Element] = []
        self.carriers: list[Element] = []
        self.pulls = [line for line in mechanism.lines if isinstance(line.law, ConstantTension)]
        self.lines: list[Line] = [*mechanism.strings, *self.pulls]
        self._contacts = mechanism.contacts
        self._options(mechanism)
        for body in mechanism.bodies:
            self._body(body)
        for site in mechanism.sites:
            made = self._carrier(site.body).add_site(name=f"s{len(self.sites)}", pos=site.at)
            self.sites[site.name] = made
        for line in self.lines:
            self._line(line)
        self.strings = self.carriers[: len(mechanism.strings)]
        for pull in self.carriers[len(mechanism.strings) :]:
            self._motor(pull)
        self.pairs = [self._sum(f"pair{number}") for number in range(len(mechanism.meetings))]
        self.locks = [self._lock(self.joints[c.slip[0][0]]) for c in mechanism.contacts.values()]

    def compile(self) -> tuple[Any, Any]:
        """Return MuJoCo's model and data; raise SimulationError if MuJoCo rejects the description."""
        try:
            model = self.spec.compile()
        except ValueError as error:
            raise SimulationError(f"MuJoCo does not compile this mechanism: {error}") from error
        return model, mujoco.MjData(model)

    def _options(self, mechanism: Mechanism) -> None:
        option = self.spec.option
        option.gravity = mechanism.gravity
        option.timestep = STEP
        option.integrator = mujoco.mjtIntegrator.mjINT_RK4
        option.solver = mujoco.mjtSolver.mjSOL_NEWTON
        option.jacobian = mujoco.mjtJacobian.mjJAC_DENSE
        option.tolerance, option.iterations = 1e-30, 100  # until rounding stops it
        option.ls_tolerance, option.ls_iterations = 1e-8, 100

    def _name(self, prefix: str) -> str:
        return f"{prefix}{len(self.carriers)}"

    def _carrier(self, body: str | None) -> Element:
        return self.spec.worldbody if body is None else self.bodies[body]

    def _body(self, body: RigidBody) -> None:
        made = self._carrier(body.parent).add_body(pos=body.at)
        self.bodies[body.name] = made
        light = TINY if body.coordinates else 0.0
        made.explicitinertial, made.ipos = True, (0.0, 0.0, 0.0)
        made.mass = max(body.mass, light)
        made.inertia = [max(body.inertia[1], made.mass * 1e-3)] * 3
        if any(c.kind == "hinge" for c in body.coordinates):
            made.inertia = [max(body.inertia[1], TINY)] * 3
        contact = self._contacts.get(body.name)
        if contact is not None:
            face = self._joint(made, "slide", contact.normal)
            face.limited, face.range = 1, (0.0, FAR)
            self.faces[body.name] = face
        for coordinate in body.coordinates:
            self.joints[coordinate.name] = self._joint(made, coordinate.kind, coordinate.axis)

    def _joint(self, body: Element, kind: Literal["slide", "hinge"], axis: tuple[float, float, float]) -> Element:
        types = {"slide": mujoco.mjtJoint.mjJNT_SLIDE, "hinge": mujoco.mjtJoint.mjJNT_HINGE}
        name = f"j{len(self.joints) + len(self.faces)}"
        joint = body.add_joint(name=name, type=types[kind], axis=axis, limited=0)
        joint.solref_limit = joint.solref_friction = (2.0 * STEP, 1.0)
        joint.solimp_limit = joint.solimp_friction = (IMPEDANCE, IMPEDANCE, 0.001, 0.5, 2.0)
        return joint

    def _tendon(self, name: str) -> Element:
        tendon = self.spec.add_tendon(name=name, limited=0, range=(-FAR, FAR))
        tendon.solref_limit = (2.0 * STEP, 1.0)
        tendon.solimp_limit = (IMPEDANCE, IMPEDANCE, 0.001, 0.5, 2.0)
        return tendon

    def _sum(self, name: str) -> Element:
        tendon = self._tendon(name)
        for joint in (*self.faces.values(), *self.joints.values()):
            tendon.wrap_joint(joint.name, 1.0)
        return tendon

    def _line(self, line: Line) -> None:
        path = self._tendon(self._name("path"))
        for name in line.through:
            path.wrap_site(self.sites[name].name)
        self.paths.append(path)
        self.carriers.append(self._sum(self._name("sum")) if line.wheels else path)

    def _lock(self, joint: Element) -> Element:
        """Return an equality constraint that locks a joint while its contact sticks."""
        lock = self.spec.add_equality(type=mujoco.mjtEq.mjEQ_JOINT, name1=joint.name, active=False)
        lock.objtype = mujoco.mjtObj.mjOBJ_JOINT
        lock.solref, lock.solimp = (2.0 * STEP, 1.0), (IMPEDANCE, IMPEDANCE, 0.001, 0.5, 2.0)
        return lock

    def _motor(self, tendon: Element) -> None:
        actuator = self.spec.add_actuator(name=f"motor{tendon.name}", trntype=mujoco.mjtTrn.mjTRN_TENDON)
        actuator.target = tendon.name
        actuator.set_to_motor()
