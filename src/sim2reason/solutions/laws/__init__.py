"""Laws of mechanics in symbols: Newton's laws of each body, kinematics at constant acceleration, equations of motion."""
