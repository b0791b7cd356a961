"""Example scenes, as the texts of scene files, with features that recipes seldom draw."""

OWN = (
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
    """scene:
  entities:
  - name: ramp
    type: TwoSideMassPlane
    parameters: {plane: {angle: 20.0, friction: 0.6}, blocks: [{mass: 2.0}]}
""",
    """scene:
  entities:
  - name: slope
    type: RollingEntity
    parameters:
      body: {kind: sphere, mass: 2.0, radius: 0.1}
      plane: {angle: 40.0}
      grip: {kind: rough, friction: 0.2}
""",
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
    """scene:
  entities:
  - name: roller
    type: TumblingPrism
    parameters: {prism: {mass: 1.0, shape: hexagonal, radius: 0.1}, plane: {angle: 12.0}, rate: 4.0}
""",
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
)
