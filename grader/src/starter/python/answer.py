"""The answer program: a question per line in, an answer per line out. raybook wrote it; you need not change it.

`raybook check` asks it, and so can you:   echo 'ray_at 0 0 0  1 0 0  2.5' | python3 answer.py
"""

import importlib
import sys
import traceback

from raybook.exercises import CHAPTERS
from raybook.words import Words, words_of


def answer(line: str) -> str:
    """The answer to a line, without the `= `."""
    name, _, rest = line.strip().partition(" ")
    if name not in CHAPTERS:
        return f"error there is no exercise `{name}`"
    chapter, types = CHAPTERS[name]
    try:
        words = Words(rest)
        arguments = importlib.import_module(types).ARGUMENTS[name](words)
        words.end()
    except ValueError as error:
        return f"error {error}"
    try:
        # A chapter is loaded when it is asked for: an error in one leaves the others be.
        function = getattr(importlib.import_module(chapter), name)
        return words_of(function(*arguments))
    except NotImplementedError as missing:
        return f"todo {missing or name}"
    except Exception as error:
        traceback.print_exc()
        return "panic " + " ".join(f"{type(error).__name__}: {error}".split())


def main() -> None:
    for line in sys.stdin:
        said = answer(line)
        # What the function printed may have left the line open, and an answer begins one.
        print(f"\n= {said}", flush=True)


if __name__ == "__main__":
    main()
