"""Laws of mechanics written down: Newton's of each body, what constant accelerations give, equations of motion."""
