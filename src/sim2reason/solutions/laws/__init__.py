"""Laws of mechanics in symbols: Newton's laws, kinematics at constant acceleration, equations of motion."""
