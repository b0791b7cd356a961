"""Formats of exports, each for a library that trains or evaluates models."""

from collections.abc import Mapping
from typing import ClassVar

from sim2reason.datasets.exports import Column, Export, Row, RowPosition, target
from sim2reason.datasets.exports.columns import (
    Letter,
    answered,
    boxed,
    conversation,
    facts,
    full_solution,
    ground_truth,
)
from sim2reason.generation.item import Item
from sim2reason.generation.options import LACKS, item_options, values
from sim2reason.questions.prompt import without_form
from sim2reason.questions.prompt_formats import LETTERS, ChoicePrompt


@target
class InspectTask(Export):
    """Inspect: a task with its samples and a scorer."""

    name = "inspect"
    also = ("inspect-ai", "inspect_evals")

    def row(self, item: Item, place: RowPosition) -> Row:
        """Return the sample of an item; its target is for readers, the scorer uses the ground truth."""
        del place
        metadata = {"ground_truth": ground_truth(item), **facts(item)}
        return {"id": item.id, "input": item.prompt, "target": item.answer.told, "metadata": metadata}


@target
class HarnessTask(Export):
    """lm-eval: a task in YAML with its Python file."""

    name = "lm-eval"
    also = ("lm_eval", "harness", "lm-evaluation-harness")

    def row(self, item: Item, place: RowPosition) -> Row:
        """Return the document of an item; few-shot examples show the target, and the grader reads `ground_truth`."""
        del place
        shown = boxed(answered(item))
        return {
            "id": item.id,
            "prompt": item.prompt,
            "target": shown,
            "ground_truth": ground_truth(item),
            **facts(item),
        }


@target
class MultipleChoice(Export):
    """Multiple choice: up to five options, distractors with their misconceptions; for any library, and lm-eval."""

    name = "multiple-choice"
    also = ("choice", "mcq")
    lacks = LACKS

    def row(self, item: Item, place: RowPosition) -> Row | None:
        """Return the question, its options in an order that depends only on the item's id, and the correct one."""
        del place
        chosen = item_options(item)
        if chosen is None:
            return None
        prompt = _prompt(item, values(item.answer, chosen))
        letters, label = LETTERS[: len(chosen)], chosen.index(None)
        return {
            "id": item.id,
            "prompt": conversation(prompt.text),
            "question": prompt.question,
            "choices": list(prompt.options),
            "answer": letters[label],
            "label": label,
            "slips": ["" if wrong is None else wrong.simplification for wrong in chosen],
            "reasons": ["" if wrong is None else wrong.reason for wrong in chosen],
            "ground_truth": ground_truth(Letter(letter=letters[label], letters=letters)),
            **facts(item),
        }


def _prompt(item: Item, numbers: list[float]) -> ChoicePrompt:
    """Return the prompt of a multiple-choice item, or the prompt of another item with options added."""
    if item.answer.letter:
        return ChoicePrompt.read(item.prompt)
    return ChoicePrompt.of(without_form(item.prompt)[0], numbers, item.answer.unit)


@target
class HuggingFace(Export):
    """Hugging Face datasets and TRL: prompts as messages; the reward is sim2reason.rewards.accuracy."""

    name = "hf"
    also = ("huggingface", "hugging-face", "datasets", "trl")
    data = "data/{split}-00000-of-00001.parquet"  # as the Hub names a split of any name
    columns: ClassVar[Mapping[str, Column]] = {
        "prompt": [{"role": str, "content": str}],
        "ground_truth": str,
        "answer": str,
        "solution": str,
        "id": str,
        "mode": str,
        "kind": str,
        "recipe": str,
        "difficulty": str,
    }

    def row(self, item: Item, place: RowPosition) -> Row:
        """Return the row of an item: the prompt, columns for rewards, a readable solution, and facts to group by."""
        del place
        columns = {"ground_truth": ground_truth(item), "answer": answered(item), "solution": full_solution(item)}
        return {"prompt": conversation(item.prompt), **columns, "id": item.id, **facts(item)}


@target
class Verl(Export):
    """verl: Parquet files, and a Python file with compute_score."""

    name = "verl"
    data = "{split}.parquet"
    columns: ClassVar[Mapping[str, Column]] = {
        "data_source": str,
        "prompt": [{"role": str, "content": str}],
        "ability": str,
        "reward_model": {"style": str, "ground_truth": str},
        "extra_info": {
            "split": str,
            "index": int,
            "id": str,
            "mode": str,
            "kind": str,
            "recipe": str,
            "difficulty": str,
        },
    }

    def row(self, item: Item, place: RowPosition) -> Row:
        """Return the row of an item; verl averages validation scores by `data_source`."""
        return {
            "data_source": "sim2reason",
            "prompt": conversation(item.prompt),
            "ability": "physics",
            "reward_model": {"style": "rule", "ground_truth": ground_truth(item)},
            "extra_info": {"split": place.split, "index": place.number, "id": item.id, **facts(item)},
        }


@target
class VerifiersTaskset(Export):
    """verifiers: a v1 taskset as an installable package."""

    name = "verifiers"
    also = ("prime-rl", "prime")
    data = "sim2reason_problems/data/{split}.jsonl"

    def row(self, item: Item, place: RowPosition) -> Row:
        """Return the task data of an item."""
        del place
        columns = {"answer": answered(item), "ground_truth": ground_truth(item), **facts(item)}
        return {"id": item.id, "prompt": item.prompt, **columns}


LICENSES = {
    "apache-2.0": "Apache 2.0",
    "mit": "MIT",
    "cc-by-4.0": "Creative Commons Attribution 4.0 International",
    "cc-by-sa-4.0": "Creative Commons Attribution-ShareAlike 4.0 International",
    "gpl-3.0": "GNU General Public License v3.0",
}
"""What NeMo Gym calls licences, by their names on the Hugging Face hub."""


@target
class NemoGym(Export):
    """NeMo Gym: JSON lines and a resources server that verifies responses."""

    name = "nemo-gym"
    also = ("nemo_gym", "nemo")
    data = "resources_servers/sim2reason/data/{split}.jsonl"

    def license(self, name: str) -> str:
        """Return NeMo Gym's name for a licence; ``TBD`` for a licence that NeMo Gym's configuration cannot name."""
        return LICENSES.get(name, "TBD")

    def row(self, item: Item, place: RowPosition) -> Row:
        """Return the input of the model, with the data that the server needs to verify a response."""
        del place
        return {
            "responses_create_params": {"input": conversation(item.prompt)},
            "id": item.id,
            "ground_truth": ground_truth(item),
            **facts(item),
        }


@target
class ReasoningGym(Export):
    """Reasoning Gym: a dataset that registers itself when its file is imported."""

    name = "reasoning-gym"
    also = ("reasoning_gym",)

    def row(self, item: Item, place: RowPosition) -> Row:
        """Return a question with a correct answer and the data for grading."""
        del place
        metadata = {"id": item.id, "ground_truth": ground_truth(item), **facts(item)}
        return {"question": item.prompt, "answer": answered(item), "metadata": metadata}
