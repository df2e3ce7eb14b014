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
from typing import Any, Callable, List, Sequence, Tuple

from .vec import Rgb, Vec2, Vec3


def answers(function: Any, questions: Sequence[Tuple[Any, ...]], words_of: Callable[[Any], str]) -> List[str]:
    """The answers to a batch of questions, each as words. A single one is asked twice at once: arrays of one hide mistakes."""
    numpy = importlib.import_module("numpy")
    asked = [*questions, *questions] if len(questions) == 1 else questions
    arguments = [stacked(numpy, values) for values in zip(*asked)]
    answers = function(*arguments)
    if not hasattr(answers, "__len__"):
        raise TypeError(f"{function.__name__} returns {answers!r:.60}: return an array or a list, with an entry for each question")
    if len(answers) != len(asked):
        raise ValueError(f"{len(answers)} answers to {len(asked)} questions")
    if isinstance(answers, numpy.ndarray):
        answers = [row(numpy.ravel(answer)) for answer in answers]
    return [words_of(answer) for answer in answers][: len(questions)]


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
