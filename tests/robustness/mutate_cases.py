"""Mutated case files: every case of the repository, changed at random, is accepted or refused with one line, never
with a crash, a hang or a message of many lines; and what is certainly wrong is never accepted.

Two sources of mutants. The files as they stand are torn: lines deleted, swapped, cut, filled with junk; any verdict
will do. Their effective cases (from `scree CASE -check`: a line a key, in SI) are broken in one known way: a misspelt key,
a key twice, a value that is no number, not finite, of another dimension, out of the range that `scree -print_options`
names, or missing; these have to be refused by the line and key. `check_cases` reads them all in one process; a part goes through the
program, which has to agree. --count N mutants (default: 1500), --seed S, --runs R of them through the program."""
import os
import queue
import random
import re
import resource
import shutil
import subprocess
import threading
from collections import Counter
from pathlib import Path

from case_reader import check_cases, effective_cases
from robust import option
from scree_program import Checks, Program

SLOWEST = 40  # seconds for one case
MEMORY = 4 << 30  # bytes of address space; the address sanitizer takes more for itself
ROOT = Path(__file__).resolve().parents[2]


# ---- torn files: any verdict will do

NUMBER = re.compile(r"-?\d+(?:\.\d+)?(?:[eE][+-]?\d+)?")
JUNK = ["0", "-1", "1e308", "-1e308", "1e999", "nan", "inf", "-inf", "", "99999999999999999999", "2147483647",
        "2147483648", "1e-320", "0x1p3", "1e9", "1,", "1 kg", "1 cm/(s", "${nothing}", "${", "((((1))))", "'", '"',
        "[", "{", "~", "!!float x", "*a", "&a 1", "|", ">", "%", "@", "\t", "\0", "é", "１", "\u202e1", "\ud7ff", "- 1", "? 1", "yes", "---", "..."]


def number(text, pick):
    places = list(NUMBER.finditer(text))
    if not places:
        return text
    place = pick.choice(places)
    return text[:place.start()] + pick.choice(JUNK) + text[place.end():]


def lines(change):
    """A mutation of the list of lines."""
    def mutate(text, pick):
        rows = text.split("\n")
        change(rows, pick)
        return "\n".join(rows)
    return mutate


def at(rows, pick):
    return pick.randrange(len(rows))


def delete(rows, pick):
    del rows[at(rows, pick)]


def duplicate(rows, pick):
    rows.insert(at(rows, pick), rows[at(rows, pick)])


def swap(rows, pick):
    i, j = at(rows, pick), at(rows, pick)
    rows[i], rows[j] = rows[j], rows[i]


def indent(rows, pick):
    i = at(rows, pick)
    rows[i] = pick.choice([" ", "    ", "\t", "\r", "\u00a0"]) + rows[i]


def junk_line(rows, pick):
    name, deep = pick.choice(["a", "grid", "boundary", "define", "particle"]), pick.choice([3, 30, 300, 3000])
    rows.insert(at(rows, pick), pick.choice([
        "".join("%s%s:\n" % (" " * level, name) for level in range(deep)) + " " * deep + "a: 1",
        "x: " + "[" * deep + "]" * deep, "x: " + "{a: " * deep + "1" + "}" * deep,
        "extent: " + "(" * deep + "1" + ")" * deep,
        "k" * 10 ** pick.randrange(1, 6) + ": 1", "gravity: " + "1, " * 10 ** pick.randrange(1, 6) + "1",
        "friction_tau: " + "9" * 10 ** pick.randrange(1, 6), "boundary_" + "a_" * pick.randrange(1, 300) + "knd: open",
        "define: {a: '${b}', b: '${a}'}\nfriction_tau: ${a}", "a: &a [1, 1]\nb: &b [*a, *a, *a]\nc: [*b, *b, *b, *b]",
        "q: &q {r: *q}", "<<: {extent: 1}", "- 1\n- 2", "--- \nextent: 1", "%YAML 9.9", "? [a, b]\n: 1",
        "grid_cells: 1e9, 1e9", "grid_refine: 1000000", "based_on: nowhere.yaml", "based_on: .", "boundary: {}", "initial: ~", ": 1", "'': 1", "=: 1",
        "restart: ''", "output_dir: ''", "\ufeffextent: 1", "x" * 70000]))


def cut(text, pick):
    return text[:pick.randrange(len(text) + 1)]


def character(text, pick):
    i = pick.randrange(len(text))
    junk = ["", "\0", "\t", "\n", "\u2028", "ü", *":,{}[]'\"#-&*!", chr(pick.randrange(1, 128))]
    return text[:i] + pick.choice(junk) + text[i + pick.randrange(2):]


def graft(text, pick):
    other = pick.choice(SEEDS)
    return cut(text, pick) + other[pick.randrange(len(other)):]


TEARS = [number, number, number, lines(delete), lines(duplicate), lines(swap), lines(indent), lines(junk_line),
         lines(junk_line), cut, character, character, graft]


def torn(text, pick):
    for _ in range(pick.choice([1, 1, 1, 2, 5])):
        text = pick.choice(TEARS)(text or "a: 1", pick)
    return text


# ---- certainly wrong: one line of an effective case, broken in a way that the table of options rules out

class Options:
    """The table of `scree -print_options`: key patterns with unit and what is allowed."""

    def __init__(self, table):
        rows = [re.split(r"(?<!\\)\|", row)[1:-1] for row in table.splitlines()[2:]]
        rows = [[cell.strip().strip("`") for cell in row] for row in rows]
        self.rows = [(re.compile(key.replace("<name>", r"[^ ]+") + "$"), unit, allowed)
                     for _, key, unit, _, allowed, _ in rows]

    def of(self, key):
        return next(((unit, allowed) for pattern, unit, allowed in self.rows if pattern.match(key)), None)


def is_number(allowed):
    words = r"any|> |>= |in [\[(]|one per|ascending|lower, upper|whole|row by row"
    return bool(re.search(words, allowed)) and "axes" not in allowed


def wrong_values(unit, allowed):
    """Values that an option of this unit and range cannot take, by kind."""
    if not is_number(allowed):
        listed = "," in allowed and "such as" not in allowed
        return {"no such choice": ["nonsense", "'${nowhere}'"]} if listed and "comma list" not in allowed else {}
    values = {"not finite": ["nan", "inf", "-inf", "1e999", "NaN", ".inf", ".nan"],
              "no number": ["", "heavy", "1..2", "1 2", "--", "0x10"], "wrong dimension": ["1 K"], "not defined": ["${nowhere}"]}
    below = {"> 0": ["0", "-1"], ">= 0": ["-1", "-1e-300"], "> 1": ["1", "0", "-1"], ">= 1": ["0", "-1", "1.5", "1e10"]}
    for text, wrong in below.items():
        if re.search(re.escape(text) + r"(?![\d.e-])", allowed):
            values["out of range"] = wrong
    if re.search(r"in [\[(]", allowed):
        values["out of range"] = ["-1e-9", "-1", "5", "1e308"]
    return values


def broken(case, options, pick):
    """(kind, text, line) with one line of a flat case broken, or None if this line cannot be. The message has to name the
    line, but for broken YAML, where it may be found out later."""
    rows = case.split("\n")
    i = pick.randrange(len(rows))
    match = re.match(r"([a-z][\w]*): (.*?)(  # .*)?$", rows[i])
    known = match and options.of(match[1])
    if not known:
        return None
    key, value = match[1], match[2]
    if pick.random() < 0.35:
        if pick.random() < 0.15:
            rows.insert(i, pick.choice(["open: [1, 2", "quote: 'no end", "map: {a: 1", "a: b: c", "\tx: 1", "x: *none",
                                        "]: 1"]))
            return "broken YAML", "\n".join(rows), None
        if pick.random() < 0.25:
            rows.insert(i, rows[i])
            return "key twice", "\n".join(rows), i + 2
        new, word = key, key.rfind("_") + 1
        while options.of(new) or new == key:
            place = pick.randrange(word, len(key))
            new = pick.choice([key[:place] + key[place + 1:], key[:place] + key[place] + key[place:],
                               key[:place] + pick.choice("abcdefghijklmnopqrstuvwxyz") + key[place + 1:]])
            if new.endswith("_"):
                new = key + "x"
        rows[i] = f"{new}: {value}"
        return "misspelt key", "\n".join(rows), i + 1
    kinds = wrong_values(*known)
    if not kinds:
        return None
    kind = pick.choice(sorted(kinds))
    wrong = pick.choice(kinds[kind])
    if value.startswith("["):
        items = value[1:-1].split(",")
        items[pick.randrange(len(items))] = wrong or "''"
        wrong = "'" + ",".join(items) + "'" if "'" not in ",".join(items) else "[" + ",".join(items) + "]"
    rows[i] = f"{key}: {wrong}"
    return kind + " of " + key, "\n".join(rows), i + 1


# ---- running them

def limit_memory():
    if "ASAN_OPTIONS" not in os.environ:
        resource.setrlimit(resource.RLIMIT_AS, (MEMORY, MEMORY))


class Reader:
    """The process check_cases, started anew after a crash or a hang."""

    def __init__(self, executable):
        self.executable, self.process = executable, None

    def start(self):
        self.process = subprocess.Popen([self.executable], stdin=subprocess.PIPE, stdout=subprocess.PIPE,
                                        stderr=subprocess.DEVNULL, preexec_fn=limit_memory)
        self.answers = queue.Queue()

        def listen(stream, answers):
            for line in stream:
                answers.put(line.decode(errors="replace").rstrip("\n"))
            answers.put(None)

        threading.Thread(target=listen, args=(self.process.stdout, self.answers), daemon=True).start()

    def verdict(self, path):
        """accepted; refused: message; crash; or hang."""
        if not self.process:
            self.start()
        self.process.stdin.write(f"{path}\n".encode())
        self.process.stdin.flush()
        try:
            answer = self.answers.get(timeout=SLOWEST)
        except queue.Empty:
            answer = "hang"
            self.process.kill()
        if answer is None or answer == "hang":
            code = self.process.wait()
            self.process = None
            return answer or f"crash: exit {code}"
        return answer

    def further_lines(self):
        """What came after the last verdict: more than one line for a file."""
        return self.answers.qsize()


def through_program(program, path):
    """The verdict of the program itself."""
    try:
        done = subprocess.run([program.scree, path, "-check"], stdin=subprocess.DEVNULL, capture_output=True,
                              timeout=SLOWEST, preexec_fn=limit_memory, cwd=program.work)
    except subprocess.TimeoutExpired:
        return "hang"
    errors = done.stderr.decode(errors="replace").splitlines()
    if done.returncode == 0 and not errors:
        return "accepted"
    if done.returncode == 1 and len(errors) == 1 and errors[0].startswith("scree: "):
        return "refused: " + errors[0][len("scree: "):]
    return f"exit {done.returncode}, {len(errors)} lines: {errors[:3]}"


def seeds():
    """The case files of the repository, copied so that based_on finds its base beside the mutants."""
    folders = {}
    for path in sorted([*ROOT.glob("cases/*/*.yaml"), *ROOT.glob("tests/**/*.yaml")]):
        if path.parent.name == "extension":  # of a program with parts of its own
            continue
        folder = program.work / path.parent.relative_to(ROOT)
        folder.mkdir(parents=True, exist_ok=True)
        folders[shutil.copy(path, folder)] = path.read_text()
    return {Path(path): text for path, text in folders.items()}


count, runs, seed = option("--count", 1500), option("--runs", 40), option("--seed", 1)
program = Program()
program.scree = str(Path(program.scree).resolve())
checks = Checks(f"{count} mutated case files, seed {seed}", "R5")
pick = random.Random(seed)
files = seeds()
SEEDS = list(files.values())
options = Options(subprocess.run([program.scree, "-print_options"], capture_output=True, text=True, check=True).stdout)
flat, plain = {}, []
for path, (accepted, text) in zip(files, effective_cases(program, files)):
    if accepted:
        flat[path] = text
    else:
        plain.append(path.name)
        print(f"  not a case alone: {path.name}: {text}")
checks.true("cases that hold as they are", len(flat) >= 0.8 * len(files), f"refused: {plain}")


def without_comments(text):
    return [row for row in text.splitlines() if not row.startswith("#")]


reader = Reader(check_cases(program))
counts, wrong, paths = Counter(), [], []
effective = {path: path.with_name(f"effective-{path.name}") for path in flat}
for path, case in flat.items():
    effective[path].write_text(case)
for path, (accepted, again) in zip(flat, effective_cases(program, effective.values())):
    # the effective case is a case, and means the same
    if not accepted or without_comments(flat[path]) != without_comments(again):
        wrong.append((path.name, "effective case", "reads otherwise" if accepted else again))
for path in pick.sample(list(flat), min(5, len(flat))):
    printed = subprocess.run([program.scree, path, "-check"], capture_output=True, text=True).stdout
    if without_comments(printed) != without_comments(flat[path]):  # the program says before what its grid is
        wrong.append((path.name, "effective case", "the program prints another"))
checks.equal("effective cases that are not understood as they were", [item for item in wrong], [])
wrong.clear()

for index in range(count):
    kind, line = None, None
    if index % 2:
        while not kind:
            path = pick.choice(list(flat))
            kind, text, line = broken(flat[path], options, pick) or (None, None, None)
    else:
        path = pick.choice(list(files))
        text = torn(files[path], pick)
    mutant = path.with_name(f"mutant-{index}.yaml")
    mutant.write_bytes(text.encode("utf-8", "surrogatepass"))
    verdict = reader.verdict(mutant)
    word = verdict.split(":")[0]
    counts[("certainly wrong: " if kind else "torn: ") + word] += 1
    one = word in ("accepted", "refused") and not reader.further_lines() and len(verdict) < 1200
    named = not line or f"{mutant.name}:{line}:" in verdict
    if not one or (kind and word != "refused") or not named:
        wrong.append((mutant.name, kind or "torn", verdict[:200]))
    paths.append((mutant, verdict))
for key, number_of in sorted(counts.items()):
    print(f"  {key}: {number_of}")
for item in wrong[:50]:
    print("  WRONG", *item)
checks.equal("mutants that crash, hang, speak in many lines, are accepted though wrong, or do not name the line", len(wrong), 0)
checks.above("torn files refused, as a share", counts["torn: refused"] / max(1, count // 2), 0.2)

differ = []
for mutant, verdict in pick.sample(paths, min(runs, len(paths))):
    by_program = through_program(program, mutant)
    if by_program != verdict:
        differ.append((mutant.name, verdict[:200], by_program[:300]))
for item in differ[:20]:
    print("  DIFFER", *item)
checks.equal(f"{runs} of them through the program: verdicts that differ", len(differ), 0)
checks.verdict()
