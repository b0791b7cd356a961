"""Problems on the fly and their reward, as a training loop would use them."""

from itertools import islice

import sim2reason

for problem in islice(sim2reason.stream(seed=1), 4):
    right = f"The answer is $\\boxed{{{problem.answer.value:.3g}\\ \\text{{{problem.answer.unit}}}}}$."
    wrong = f"It must be \\boxed{{{-1.2 * problem.answer.value:.3g}}}."
    for response in (right, wrong, "I do not know."):
        score = sim2reason.grade(problem, response)
        print(f"{problem.id}: {score.reward:.0f}  {score.outcome}  {score.why}")
