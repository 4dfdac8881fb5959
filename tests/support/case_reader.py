"""Cases as the program understands them, many in one process of check_cases: a start of the program takes far longer than
to read a case."""
import subprocess
from pathlib import Path


def check_cases(program):
    """The executable beside the program."""
    return Path(program.scree).resolve().parent / "check_cases"


def effective_cases(program, paths):
    """The case that `scree CASE -check` prints for each path, or its complaint: lists of (accepted, text)."""
    paths = [str(path) for path in paths]
    done = subprocess.run([check_cases(program), "-print"], input="".join(path + "\n" for path in paths), capture_output=True,
                          text=True, timeout=600)
    lines = iter(done.stdout.splitlines())
    verdicts = []
    for path in paths:
        verdict = next(lines, f"none: check_cases ended with {done.returncode}")
        word, _, rest = verdict.partition(" ")
        if word == "accepted":
            verdicts.append((True, "".join(next(lines) + "\n" for _ in range(int(rest)))))
        else:
            verdicts.append((False, rest))
    return verdicts
