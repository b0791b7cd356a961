"""Scenes are values: change a number, take a thing away, or glue a body down, and compare."""

import sim2reason

scene = sim2reason.sample("incline", "easy", seed=3, index=1)
print(sim2reason.describe(scene).text)
for parameter in scene.parameters:
    if not parameter.hidden and parameter.value is not None:
        print(f"  {parameter.path} = {parameter.measure.say(parameter.value)}")

moon = scene.having("world.gravity", 1.6)
for name, world in (("on Earth", scene), ("on the Moon", moon)):
    trace = sim2reason.simulate(world, duration=0.5)
    print(f"{name}: ends at {trace.stable_until:.3f} s, accelerations {trace.state.a[0].round(3)}")
