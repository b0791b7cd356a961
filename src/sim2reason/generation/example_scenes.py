"""Example scene files with features that recipes rarely draw, and questions about them."""

from typing import NamedTuple


class ExampleScene(NamedTuple):
    """The text of a scene file, with questions in ordinary English that recipes never ask."""

    text: str
    asked: tuple[str, ...] = ()


OWN = (
    ExampleScene(
        """scene:
  entities:
  - name: lane
    type: RollingEntity
    parameters:
      body: {kind: sphere, mass: 2.0, radius: 0.1}
      plane: {angle: 0.0}
      grip: {kind: rough, friction: 0.2}
      start: {kind: rolling, way: to the right, speed: 3.0}
  - {name: hook, type: FixedSupport}
  connections:
  - spring: [{entity: lane, direction: axle}, {entity: hook, direction: end}]
    stiffness: 30.0
""",
        (
            "How many revolutions does the sphere make in the first 0.5 s?",
            "What is the moment of inertia of the sphere about its axis?",
            "What is the stiffness of the spring?",
        ),
    ),
    ExampleScene(
        """scene:
  entities:
  - name: floor
    type: TwoSideMassPlane
    parameters: {plane: {angle: 0.0, friction: 0.0}, blocks: [{mass: 2.0}], speed: 1.5}
  - {name: hook, type: FixedSupport}
  connections:
  - spring: [{entity: floor, direction: right}, {entity: hook, direction: end}]
    stiffness: 30.0
""",
    ),
    ExampleScene(
        """scene:
  entities:
  - name: ramp
    type: TwoSideMassPlane
    parameters: {plane: {angle: 0.0, friction: 0.0}, blocks: [{mass: 2.0}]}
  - name: shelf
    type: TwoSideMassPlane
    parameters: {plane: {angle: 0.0, friction: 0.0}, blocks: [{mass: 1.0}]}
  connections:
  - rod: [{entity: ramp, direction: right}, {entity: shelf, direction: left}]
""",
    ),
    ExampleScene(
        """scene:
  entities:
  - {name: rail, type: SliderMass, parameters: {carriage: {mass: 2.0}}}
  - name: bob
    type: LightRodPendulum
    parameters: {bob: {mass: 0.5}, rod: {length: 0.6}, angle: 40.0}
  - name: floor
    type: TwoSideMassPlane
    parameters: {plane: {angle: 0.0, friction: 0.0}, blocks: [{mass: 1.0}], speed: 1.0}
  connections:
  - weld: [{entity: rail, direction: pivot}, {entity: bob, direction: base}]
  - spring: [{entity: rail, direction: right}, {entity: floor, direction: left}]
    stiffness: 30.0
""",
    ),
    ExampleScene(
        """scene:
  entities:
  - name: ramp
    type: TwoSideMassPlane
    parameters: {plane: {angle: 20.0, friction: 0.6}, blocks: [{mass: 2.0}]}
""",
        ("What coefficient of friction is needed to keep the block from slipping?",),
    ),
    ExampleScene(
        """scene:
  entities:
  - name: slope
    type: RollingEntity
    parameters:
      body: {kind: sphere, mass: 2.0, radius: 0.1}
      plane: {angle: 40.0}
      grip: {kind: rough, friction: 0.2}
""",
    ),
    ExampleScene(
        """scene:
  entities:
  - name: machine
    type: MassWithFixedPulley
    parameters: {system: {kind: hanging, blocks: [{mass: 3.0}]}, pulley: {mass: 0.0}}
  - name: load
    type: HangingMass
    parameters: {system: {blocks: [{mass: 5.0}]}}
  connections:
  - tendon: [{entity: machine, direction: tail}, {entity: load, direction: end}]
""",
        (
            "What force does the string exert on the pulley?",
            "How far above its starting point is block A 0.5 s after release?",
            "How fast do blocks A and B move relative to each other at t = 0.5 s?",
        ),
    ),
    ExampleScene(
        """scene:
  entities:
  - name: rail
    type: SpringMassChain
    parameters:
      track: {angle: 0.0}
      carts: [{mass: 1.0}]
      ends: left
      springs: [{stiffness: 20.0}]
      damping: 0.5
      strain: {spring: 0, way: stretched, by: 0.2}
""",
    ),
    ExampleScene(
        """scene:
  entities:
  - name: field
    type: EmEntity
    parameters:
      magnetic: {kind: uniform_magnetic, strength: 0.5, way: positive z}
      region: {kind: strip, low: 1.0, high: 3.0}
      particle: {mass: 4.0, charge: 8.0, sign: positive}
      start: {kind: launched, speed: 10.0, angle: 0.0}
""",
    ),
    ExampleScene(
        """scene:
  entities:
  - name: field
    type: EmEntity
    parameters:
      electric: {kind: uniform_electric, strength: 30.0, way: positive x}
      medium: {kind: linear_drag, coefficient: 3.0}
      particle: {mass: 6.0, charge: 1.0, sign: positive}
      start: {kind: released}
""",
        (
            "What electric force acts on the bead?",
            "How large is the resisting force on the bead at t = 0.5 s?",
        ),
    ),
    ExampleScene(
        """scene:
  entities:
  - name: roller
    type: TumblingPrism
    parameters: {prism: {mass: 1.0, shape: hexagonal, radius: 0.1}, plane: {angle: 12.0}, rate: 4.0}
""",
    ),
    ExampleScene(
        """scene:
  entities:
  - {name: rail, type: SliderMass, parameters: {carriage: {mass: 2.4}}}
  - name: bob
    type: RigidPendulum
    parameters: {arm: {}, pieces: [{kind: ball_piece, distance: 0.4, side: from the axle, body: {mass: 6.0}}],
      angle: 50.0}
  - {name: hand, type: ConstantForcePuller, parameters: {force: 60.0}}
  connections:
  - pivot: [{entity: rail, direction: pivot}, {entity: bob, direction: axle}]
  - tendon: [{entity: rail, direction: left}, {entity: hand, direction: end}]
    free: 2.0
""",
        ("What is the power of the hand at t = 0.5 s?",),
    ),
)
