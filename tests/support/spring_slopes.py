"""Scene with a block on a smooth slope of 18°, a spring at its foot, and a load over a heavy pulley."""

from sim2reason import load
from sim2reason.scenes.dsl.scene import Scene

TEXT = """
scene:
  name: scene
  entities:
  - name: slope
    type: SpringMassIncline
    parameters:
      plane: {{angle: 18.0, friction: 0.0}}
      block: {{mass: 2.3}}
      spring: {{stiffness: {stiffness}, length: 0.45}}
      start: 0.2
  - name: load
    type: MassWithFixedPulley
    parameters:
      system: {{kind: hanging, length: 30.0, blocks: [{{mass: 4.7}}]}}
      pulley: {{mass: 1.7}}
  connections:
  - tendon:
    - {{entity: slope, direction: right}}
    - {{entity: load, direction: tail}}
    free: 39.0
  world: {{gravity: 9.8}}
"""


def spring_slope(stiffness: float) -> Scene:
    """Return the scene with a spring of the given stiffness in N/m."""
    return load(TEXT.format(stiffness=stiffness))
