#!/usr/bin/env bash
# Pinocchio: the tip of a steadily turning rod has no acceleration, by getFrameAcceleration in any
# frame.
#
# Package: pin 4.1.0 (Pinocchio), Python 3.11. Date: 2026-11-30.
# Expected: a tip 1 m from the axle at 2 rad/s has an acceleration of omega^2 r = 4 m/s^2 towards
# the axle.
# Seen:
#   getFrameAcceleration, LOCAL: [0. 0. 0.]
#   getFrameAcceleration, LOCAL_WORLD_ALIGNED: [0. 0. 0.]
#   getFrameAcceleration, WORLD: [0. 0. 0.]
#   getFrameClassicalAcceleration, LOCAL_WORLD_ALIGNED: [-4.  0.  0.]
# Note: it is the spatial acceleration; getFrameClassicalAcceleration gives the one of Newton's law
# and of accelerometers.
# Exits with 0 while this holds, with 1 when it has changed, with 2 where the packages cannot be installed.
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
python3 -m venv "$folder/venv" || exit 2
"$folder/venv/bin/pip" install -qq 'pin==4.1.0' || exit 2
"$folder/venv/bin/python" - <<'PYTHON'
import sys

import numpy as np
import pinocchio as pin

model = pin.Model()
joint = model.addJoint(0, pin.JointModelRZ(), pin.SE3.Identity(), "axle")
model.appendBodyToJoint(joint, pin.Inertia(1.0, np.array([0.5, 0.0, 0.0]), 0.1 * np.eye(3)), pin.SE3.Identity())
place = pin.SE3(np.eye(3), np.array([1.0, 0.0, 0.0]))
tip = model.addFrame(pin.Frame("tip", joint, 0, place, pin.FrameType.OP_FRAME))
data = model.createData()
pin.forwardKinematics(model, data, np.zeros(1), np.array([2.0]), np.zeros(1))
pin.updateFramePlacements(model, data)
lengths = []
for frame in (pin.LOCAL, pin.LOCAL_WORLD_ALIGNED, pin.WORLD):
    spatial = pin.getFrameAcceleration(model, data, tip, frame).linear
    lengths.append(np.linalg.norm(spatial))
    print(f"getFrameAcceleration, {frame}:", np.round(spatial, 6) + 0.0)
classical = pin.getFrameClassicalAcceleration(model, data, tip, pin.LOCAL_WORLD_ALIGNED).linear
print("getFrameClassicalAcceleration, LOCAL_WORLD_ALIGNED:", np.round(classical, 6) + 0.0)
if max(lengths) > 1e-9 or abs(np.linalg.norm(classical) - 4) > 1e-9:
    sys.exit("The behaviour has changed.")
PYTHON
