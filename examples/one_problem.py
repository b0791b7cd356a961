"""One problem by its coordinates: the same recipe, difficulty, seed and index always give the same problem."""

import sim2reason

problem = sim2reason.item(recipe="pulley", difficulty="easy", seed=7, index=0)
print(problem.prompt)
print(f"\nAnswer: {problem.answer.shown}")
print(f"The two engines differ by {problem.certificate['worst']:.1e} of the scene's scale.")
