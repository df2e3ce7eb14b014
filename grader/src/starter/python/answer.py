"""The answer program: a question per line in, an answer per line out. raybook wrote it; you need not change it.

`raybook check` asks it, and so can you:   echo 'ray_at 0 0 0  1 0 0  2.5' | python3 answer.py
"""

import functools
import importlib
import itertools
import os
import signal
import sys
import traceback
from typing import Any, Callable, Iterable, Iterator, List, Tuple

from raybook import batch
from raybook.exercises import CHAPTERS
from raybook.words import Words, words_of

# This file, and the folder of yours.
FILE = os.path.abspath(__file__)
FOLDER = os.path.dirname(FILE)
# The maximum number of places of a program that are looked at, the innermost ones.
MOST = 50


def name_of(line: str) -> str:
    """Which function a question is for."""
    return line.strip().partition(" ")[0]


@functools.lru_cache(maxsize=None)
def types_of(name: str) -> Any:
    """The module that says what a function is given and returns."""
    return importlib.import_module(CHAPTERS[name][1])


@functools.lru_cache(maxsize=None)
def chapter_of(name: str) -> Any:
    """Your file with a function. It is loaded when it is asked for: an error in one leaves the others be."""
    return importlib.import_module(CHAPTERS[name][0])


def arguments_of(line: str) -> Tuple[Any, ...]:
    """What the function is given."""
    name, _, rest = line.strip().partition(" ")
    words = Words(rest)
    arguments: Tuple[Any, ...] = types_of(name).ARGUMENTS[name](words)
    words.end()
    return arguments


def told(name: str, value: Any) -> str:
    """What a function returns, in words."""
    types = types_of(name)
    return words_of(value, types.ANSWERS[name], vars(types))


def guarded(name: str, function: Callable[[], List[str]]) -> List[str]:
    """The answers, or in their place why there are none."""
    try:
        return function()
    except NotImplementedError as missing:
        return [f"todo {missing or name}"]
    except Exception as error:
        complain(error)
        return ["panic " + " ".join(f"{type(error).__name__}: {error}".split())]


def complain(error: Exception) -> None:
    """Prints where in your own files an error is, and what it is."""
    frames = own(traceback.extract_tb(error.__traceback__, limit=-MOST))
    if isinstance(error, RecursionError):  # the places to which it comes again and again, once each
        again = [frame for i, frame in enumerate(frames) if frame in frames[:i]]
        frames = [frame for i, frame in enumerate(again) if frame not in again[:i]]
    report = traceback.format_list(frames) + traceback.format_exception_only(type(error), error)
    print("".join(report), end="", file=sys.stderr)


def own(frames: Iterable[traceback.FrameSummary]) -> List[traceback.FrameSummary]:
    """Those in your own files, which lie beside this one."""
    return [frame for frame in frames if os.path.dirname(frame.filename) == FOLDER and frame.filename != FILE]


def say_where(_signal: int, frame: Any) -> None:
    """Prints where in your own files the program is, and ends it: raybook asks this when an answer takes too long."""
    here = traceback.format_list(own(traceback.extract_stack(frame))[-4:])
    print("".join(["It is here, the innermost last:\n", *here]), end="", file=sys.stderr, flush=True)
    os._exit(1)


def called(name: str, arguments: Tuple[Any, ...]) -> str:
    """What a function returns, in words."""
    return told(name, getattr(chapter_of(name), name)(*arguments))


def answer(line: str) -> str:
    """The answer to a line, without the `= `."""
    name = name_of(line)
    try:
        arguments = arguments_of(line)
    except ValueError as error:
        return f"error {error}"
    return guarded(name, lambda: [called(name, arguments)])[0]


def answers(name: str, lines: List[str]) -> Iterator[str]:
    """The answers to questions of one exercise: all at once, where there is a function for a batch of them."""
    if name not in CHAPTERS:
        return (f"error there is no exercise `{name}`" for _ in lines)
    try:
        function = getattr(chapter_of(name), f"{name}_batch", None)
        questions = [arguments_of(line) for line in lines] if function else []
    except Exception:
        function, questions = None, []  # Each question says by itself what is wrong.
    if function is None:
        return map(answer, lines)
    said = guarded(name, lambda: batch.answers(function, questions, lambda value: told(name, value)))
    return iter(said if len(said) == len(lines) else said * len(lines))


def main() -> None:
    if hasattr(signal, "SIGUSR1"):  # not on Windows
        signal.signal(signal.SIGUSR1, say_where)
    rest = b""
    while read := os.read(sys.stdin.fileno(), 1 << 16):  # all that is there, without waiting for more
        *lines, rest = (rest + read).split(b"\n")
        tell(lines)
    tell([rest] if rest else [])


def tell(lines: List[bytes]) -> None:
    """Answers questions, in their order."""
    texts = [line.decode(errors="replace") for line in lines]
    for name, alike in itertools.groupby(texts, name_of):
        for said in answers(name, list(alike)):
            # What the function printed may have left the line open, and an answer begins one. With the end in the text it is one write.
            print(f"\n= {said}\n", end="", flush=True)


if __name__ == "__main__":
    main()
