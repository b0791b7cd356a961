"""A scene of one's own: written in the builder's terms, told in words, simulated by both engines."""

import sim2reason

SCENE = """
scene:
  name: atwood
  entities:
    - name: left
      type: MassWithFixedPulley
      parameters: {system: {kind: hanging, blocks: [{mass: 2.0}]}, pulley: {mass: 0.0}}
    - name: right
      type: MassWithFixedPulley
      parameters: {system: {kind: hanging, blocks: [{mass: 3.0}]}, pulley: {mass: 0.0}}
  connections:
    - tendon: [{entity: left, direction: tail}, {entity: right, direction: tail}]
"""

scene = sim2reason.load(SCENE)
print(sim2reason.describe(scene).text)
trace, certificate = sim2reason.certify(scene, duration=1.0)
heavy = trace.state.a[0, 0]
print(f"\nThe 2.0 kg block accelerates at {heavy:.6f} m/s²; (3 − 2)g/(3 + 2) is {9.8 / 5:.6f} m/s².")
print(f"Largest difference of the engines: {max(certificate.agreement.values()):.1e}")
