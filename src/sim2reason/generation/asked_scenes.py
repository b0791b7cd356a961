"""Example scenes for questions and entities that recipes rarely or never produce."""

from sim2reason.generation.example_scenes import ExampleScene

ASKED = (
    ExampleScene(
        """scene:
  entities:
  - name: slide
    type: SpringOnWedge
    parameters:
      wedge: {mass: 3.0, angle: 30.0, friction: 0.0}
      block: {mass: 2.0}
      spring: {stiffness: 100.0, length: 0.5}
      start: 0.6
""",
    ),
    ExampleScene(
        """scene:
  entities:
  - name: slide
    type: SpringOnWedge
    parameters:
      wedge: {mass: 0.5, angle: 45.0, friction: 0.0}
      block: {mass: 2.0}
      spring: {stiffness: 300.0, length: 0.5}
      start: 0.2
""",
    ),
    ExampleScene(
        """scene:
  entities:
  - name: wheel
    type: BlocksOnSteppedPulley
    parameters:
      pulley: {inner: 0.1, outer: 0.2, inertia: 0.05}
      outer_block: {mass: 3.0}
      inner_block: {mass: 2.0}
""",
    ),
    ExampleScene(
        """scene:
  entities:
  - name: necklace
    type: SpringMassRing
    parameters:
      radius: 0.5
      beads: [{mass: 0.5}, {mass: 0.8}]
      springs: [{stiffness: 20.0}, {stiffness: 30.0}]
      strain: {spring: 0, way: stretched, by: 0.2}
""",
    ),
    ExampleScene(
        """scene:
  entities:
  - name: machine
    type: MassWithFixedPulley
    parameters: {system: {kind: hanging, blocks: [{mass: 3.0}]}, pulley: {mass: 0.0}}
  - {name: winch, type: ConstantVelocityPuller, parameters: {speed: 0.4}}
  connections:
  - tendon: [{entity: machine, direction: tail}, {entity: winch, direction: end}]
""",
        (
            "By how much does the length of the string change in the first 0.5 s?",
            "How fast is the length of the string changing at t = 0.5 s?",
        ),
    ),
    ExampleScene(
        """scene:
  entities:
  - name: pendulum
    type: Pendulum
    parameters:
      bob: {mass: 0.5}
      hanger: {kind: cord, length: 0.5}
      angle: 10.0
      speed: 2.0
""",
        ("What is the least launch speed for which the ball completes full circles?",),
    ),
    ExampleScene(
        """scene:
  entities:
  - name: rocket
    type: RocketEntity
    parameters:
      rocket: {mass: 700.0, dry: 200.0}
      place: {kind: level_ground}
      exhaust: 2.5
      rate: 2.5
""",
        (
            "What is the minimum exhaust speed for which the probe lifts off as soon as the engine is lit?",
            "How much fuel has the probe burnt at t = 30 s?",
            "How much fuel is left at t = 30 s?",
            "How large is the thrust of the engine at t = 30 s?",
        ),
    ),
    ExampleScene(
        """scene:
  entities:
  - name: roller
    type: TumblingPrism
    parameters:
      prism: {mass: 1.0, shape: decagonal, radius: 0.1}
      plane: {angle: 12.0}
      rate: 5.0
""",
        ("With what least initial angular velocity would the prism just manage to tip over its lower edge?",),
    ),
    ExampleScene(
        """scene:
  entities:
  - name: system
    type: SolarSystem
    parameters:
      star: {mass: 1.0}
      planets: [{kind: planet, x: 1.0, y: 0.0, vx: 0.0, vy: 7.0}]
""",
        (
            "What is the eccentricity of the orbit?",
            "What is the semi-major axis of the orbit?",
            "With what speed would the planet have to start to move in a circle?",
        ),
    ),
    ExampleScene(
        """scene:
  entities:
  - name: fields
    type: EmEntity
    parameters:
      magnetic: {kind: uniform_magnetic, strength: 0.5, way: positive z}
      particle: {mass: 4.0, charge: 2.0, sign: positive}
      start: {kind: launched, speed: 3.0, angle: 0.0}
""",
        (
            "What magnetic force acts on the bead?",
            "What is the radius of the path of the bead?",
            "Through what angle is the bead deflected in the first 2.0 s?",
            "What is the x coordinate of the bead at t = 2.0 s?",
            "What is the y coordinate of the bead at t = 2.0 s?",
            "How far is the bead from the origin at t = 2.0 s?",
        ),
    ),
    ExampleScene(
        """scene:
  entities:
  - name: throw
    type: Projectile
    parameters:
      ball: {mass: 0.5}
      height: 2.0
      speed: 8.0
      angle: 30.0
""",
        (
            "What angle does the velocity of the ball make with the horizontal at t = 0.5 s?",
            "How high above the ground is the ball at t = 0.5 s?",
        ),
    ),
    ExampleScene(
        """scene:
  entities:
  - name: roller
    type: RollingEntity
    parameters:
      body: {kind: bored_cylinder, mass: 4.0, radius: 0.2, hole: 0.1, offset: 0.05}
      plane: {angle: 10.0}
      hole: {bearing: 20.0, towards: uphill}
      grip: {kind: no_slipping}
""",
        ("How far from the axis of the cylinder is its centre of mass?",),
    ),
    ExampleScene(
        """scene:
  entities:
  - name: box
    type: MassBoxPlane
    parameters:
      box: {mass: 4.0, friction: 0.0}
      blocks: [{mass: 2.0}]
      right: {mass: 1.0}
      length: 2.5
""",
        (
            "What is the acceleration of block A relative to the box just after release?",
            "How far does block A move relative to the box in the first 0.5 s?",
            "How fast is block A moving relative to the box at t = 0.5 s?",
            "What force does the guide exert on block B?",
        ),
    ),
    ExampleScene(
        """scene:
  entities:
  - name: arm
    type: RotationEntity
    parameters:
      arm: {}
      pieces:
      - kind: axial_piece
        distance: 0.2
        side: from the axle
        body: {kind: uniform_rod, mass: 2.0, length: 0.8}
        axis: at right angles to both arm and axle
      angle: 40.0
""",
        (
            "How far is the centre of the rod from the axle?",
            "What is the moment of inertia of the rod about the axle?",
            "What force does the rod exert on the axle just after release?",
        ),
    ),
    ExampleScene(
        """scene:
  entities:
  - {name: rail, type: SliderMass, parameters: {carriage: {mass: 2.0}}}
  - name: bob
    type: LightRodPendulum
    parameters: {bob: {mass: 1.3}, rod: {length: 0.9}, angle: 50.0}
  connections:
  - pivot: [{entity: rail, direction: pivot}, {entity: bob, direction: base}]
""",
        ("With what force does the rod pull the ball at t = 0.3 s?",),
    ),
    ExampleScene(
        """scene:
  entities:
  - name: load
    type: MassWithFixedPulley
    parameters: {system: {kind: hanging, blocks: [{mass: 1.4}]}, pulley: {mass: 0.0}}
  - name: slope
    type: TwoSideMassPlane
    parameters: {plane: {angle: 26.0, friction: 0.4}, blocks: [{mass: 1.4}]}
  connections:
  - tendon: [{entity: load, direction: tail}, {entity: slope, direction: right}]
""",
        ("What mass must B have for A to move down the slope at constant speed?",),
    ),
    ExampleScene(
        """scene:
  entities:
  - name: guide
    type: DirectedMass
    parameters:
      block: {mass: 2.0}
      left_distance: 1.0
      left_angle: 40.0
      left_side: above
      right_distance: 1.5
      right_angle: 20.0
      right_side: above
  - {name: hand, type: ConstantForcePuller, parameters: {force: 20.0}}
  - {name: other, type: ConstantForcePuller, parameters: {force: 30.0}}
  connections:
  - tendon: [{entity: guide, direction: side_1}, {entity: hand, direction: end}]
  - tendon: [{entity: guide, direction: side_2}, {entity: other, direction: end}]
""",
    ),
    ExampleScene(
        """scene:
  entities:
  - name: machine
    type: MassWithFixedPulley
    parameters: {system: {kind: hanging, blocks: [{mass: 3.0}]}, pulley: {mass: 0.0}}
  - {name: lower, type: ThreePointMovablePulley, parameters: {pulley: {mass: 0.0}}}
  - {name: hook, type: FixedSupport}
  - {name: load, type: HangingMass, parameters: {system: {blocks: [{mass: 5.0}]}}}
  connections:
  - tendon: [{entity: hook, direction: end}, {entity: lower, direction: left}]
  - tendon: [{entity: lower, direction: right}, {entity: machine, direction: tail}]
  - tendon: [{entity: lower, direction: eye}, {entity: load, direction: end}]
""",
    ),
    ExampleScene(
        """scene:
  entities:
  - name: table
    type: TwoDCollisionPlane
    parameters:
      table: {angle: 0.0}
      radius: 0.1
      pucks:
      - {mass: 1.0, x: 0.0, y: 0.0, vx: 1.0, vy: 0.0}
      - {mass: 2.0, x: 1.0, y: 0.1, vx: 0.0, vy: 0.0}
      restitution: 0.5
""",
        ("What is the velocity of the centre of mass of the pucks?",),
    ),
)
