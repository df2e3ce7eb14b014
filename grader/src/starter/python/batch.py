"""Many questions at once, as arrays of numpy. raybook wrote this file; you need not change it.

A picture asks thousands of questions. Beside a function you may write one for a batch of them: `plane_hit_batch` beside `plane_hit`,
with the same parameters, in the same file. It is then called in place of the other, with an array for each number:

    number, whole number          an array with an entry for each question
    vector, direction, colour     an array with a row for each question
    ray, interval, other records  as ever, but made of such arrays: ray.origin is one, within.min another
    list, and what may be missing a list with an entry for each question

It returns an array with an entry, or a row of numbers, for each question, and NaN where there is no answer; or a list of answers.
"""

from __future__ import annotations

import importlib
from typing import Any, List, Sequence, Tuple

from .vec import Rgb, Vec2, Vec3
from .words import words_of


def answers(function: Any, questions: Sequence[Tuple[Any, ...]]) -> List[str]:
    """The answers to a batch of questions, each as words."""
    numpy = importlib.import_module("numpy")
    arguments = [stacked(numpy, values) for values in zip(*questions)]
    answers = function(*arguments)
    if len(answers) != len(questions):
        raise ValueError(f"{len(answers)} answers to {len(questions)} questions")
    if isinstance(answers, numpy.ndarray):
        return [row(numpy.ravel(answer)) for answer in answers]
    return [words_of(answer) for answer in answers]


def stacked(numpy: Any, values: Sequence[Any]) -> Any:
    """The values of one parameter: those of all questions together."""
    first = values[0]
    if isinstance(first, (Vec2, Vec3, Rgb)):
        return numpy.array([tuple(value) for value in values])
    if isinstance(first, (int, float)):
        return numpy.array(values)
    fields = getattr(first, "__dataclass_fields__", None)
    if fields is None or any(type(value) is not type(first) for value in values):
        return list(values)
    return type(first)(*(stacked(numpy, [getattr(value, name) for value in values]) for name in fields))


def row(numbers: Any) -> str:
    """The numbers of one answer; none if they are NaN."""
    if all(number != number for number in numbers):
        return "none"
    return " ".join(f"{number:.9g}" for number in numbers)
