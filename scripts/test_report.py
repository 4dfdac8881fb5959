#!/usr/bin/env python3
"""Writes tests/results/, the pages of what the tests measured, from what they left in a build directory: checks.json of
the scripts (tests/support/scree_program.py) and order_*.json of the manufactured solutions. Hand-written notes come
from tests/results/notes.md."""
import argparse
import json
import re
import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]
LABELS = ("verification", "stability", "manufactured", "robustness")

INTRODUCTION = """\
# Results of the tests

Written by `scripts/test_report.py` from the last run of {labels}. [tests](../README.md) says what the ids mean and how
to run them, [VERIFICATION.md](../VERIFICATION.md) has the problems and their exact solutions.

A check that does not hold is a miss and stands here first. Numbers have three digits; `off by` is measured less exact.
Checks alike in all runs of a script are one line, with the worst. Explanations come from `tests/results/notes.md`.

| page | what |
|---|---|
{pages}
"""
#: Page -> its title, the letter of its ids, what it has.
PAGES = {
    "orders.md": ("Order of accuracy", None, "order in space and time for each unknown, manufactured solutions (T19)"),
    "exact.md": ("Exact solutions", "T", "exact and semi-analytic solutions (T1 to T24)"),
    "hard.md": ("Hard cases", "H", "hard cases (H1 to H20)"),
    "robustness.md": ("Robustness", "R", "what the program stands (R1 to R7)"),
}


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--build", type=Path, default=ROOT / "build", help="build directory (build)")
    parser.add_argument("--run", action="store_true", help="run the tests first")
    parser.add_argument("--also", type=Path, action="append", default=[], help="further directory of results")
    parser.add_argument("--output", type=Path, default=ROOT / "tests" / "results", help="directory of the pages")
    given = parser.parse_args()
    if given.run:  # misses are for the page to show
        subprocess.run(["ctest", "--test-dir", given.build, "-L", f"^({'|'.join(LABELS)})$", "--output-on-failure"],
                       check=False)
    records = scripts(given.build, given.also)
    orders = order_tables([given.build / "tests", *given.also])
    if not records and not orders:
        sys.exit(f"no results below {given.build}/tests")
    given.output.mkdir(parents=True, exist_ok=True)
    for name, text in pages(records, orders, missing(records), notes(ROOT / "tests" / "results" / "notes.md")).items():
        (given.output / name).write_text(text)
    print(f"wrote {given.output}: {len(records)} scripts, {len(orders)} order tables")


# ---- collecting ----


def scripts(build, also):
    """The records of all scripts, in the order of their ids; of runs on several numbers of ranks the one on fewest."""
    best = {}
    for top in [build / "tests", *also]:
        for path in sorted(top.rglob("checks.json")):
            if "regression" in path.parts:  # stored numbers, not measured against anything
                continue
            name, _, ranks = path.parent.name.rpartition("_")
            if not ranks.isdigit():
                name, ranks = path.parent.name, 1
            key = (str(path.parent.parent), name)
            if key not in best or int(ranks) < best[key][0]:
                best[key] = (int(ranks), {**json.loads(path.read_text()), "script": name})
    return sorted((record for _, record in best.values()), key=lambda r: (id_key(r["ids"]), r["title"]))


def order_tables(tops):
    """The rows of all tables; of those that were measured more than once the one on most grids."""
    best = {}
    for top in tops:
        for path in sorted(top.rglob("order_*.json")):
            for row in json.loads(path.read_text()):
                key = row["case"], row["unknown"], row["norm"]
                if key not in best or len(row["grids"]) > len(best[key]["grids"]):
                    best[key] = row
    return list(best.values())


def missing(records):
    """Scripts of the labels that left no result: they ended early, or did not run."""
    found = {record["script"] for record in records}
    return [f"{label}/{path.name}" for label in LABELS for path in sorted((ROOT / "tests" / label).glob("*.py"))
            if "Checks(" in path.read_text() and path.stem not in found]


def notes(path):
    """Heading -> text of the sections of the hand-written notes."""
    sections = {}
    if path.exists():
        for part in re.split(r"^## ", path.read_text(), flags=re.M)[1:]:
            heading, _, text = part.partition("\n")
            sections[heading.strip()] = text.strip()
    return sections


def id_key(ids):
    """Sorts T2 before T10; without ids last."""
    first = ids[0] if ids else "~"
    digits = re.sub(r"\D", "", first)
    return re.sub(r"\d", "", first), int(digits or 0)


def kind(record):
    """T, H or R, by the first id; what has none is with the hard cases."""
    return record["ids"][0][0] if record["ids"] else "H"


# ---- numbers and tables ----


def short(value):
    """A number with three digits."""
    if value is None:
        return "-"
    text = f"{value:.3g}"
    return re.sub(r"e([+-])0*(\d)", lambda m: "e" + m[1].replace("+", "") + m[2], text)


def shortened(text):
    """A text whose long numbers are cut to three digits."""

    def cut(match):
        number = match[0]
        long = "e" in number or len(re.sub(r"[-.]", "", number).lstrip("0")) > 3
        return short(float(number)) if long else number

    return re.sub(r"(?<![\w.])-?\d*\.?\d+(?:e[+-]?\d+)?(?![\w.])", cut, str(text))


def cell(text):
    return str(text).replace("|", "\\|").replace("\n", " ")


def table(head, rows):
    lines = ["| " + " | ".join(head) + " |", "|" + "---|" * len(head)]
    return "\n".join(lines + ["| " + " | ".join(cell(item) for item in row) + " |" for row in rows]) + "\n"


# ---- the page ----


def pages(records, orders, absent, sections):
    """Name of a page -> its text."""
    own = {letter: [record for record in records if kind(record) == letter] for letter in "THR"}
    texts = {None: order_section(orders), "T": check_section(own["T"]),
             "H": hard_section(records, own["H"], "H"), "R": hard_section(records, own["R"], "R")}
    links = "\n".join(f"| [{name}]({name}) | {what} |" for name, (_, _, what) in PAGES.items())
    result = {"README.md": INTRODUCTION.format(labels=", ".join(LABELS), pages=links) + "\n"
              + misses(records, orders, absent)}
    for name, (title, letter, _) in PAGES.items():
        result[name] = f"# {title}\n\n{texts[letter]}" + remarks(sections, letter)
    return result


def remarks(sections, letter):
    """The hand-written notes that belong to a page, by the letter of their ids."""
    own = {name: text for name, text in sections.items() if (re.match(r"[THR]\d", name) and name[0] or None) == letter}
    if not own:
        return ""
    order = sorted(own, key=lambda name: id_key([name]))
    return "\n## Explanations\n\n" + "\n".join(f"### {name}\n\n{own[name]}\n" for name in order)


def misses(records, orders, absent):
    lines = []
    for record in records:
        for check in record["checks"]:
            if not check["good"]:
                lines.append(f"- {', '.join(record['ids']) or record['script']}: {check['case']}: measured "
                             f"{shortened(check['measured'])}, expected {shortened(check['expected'])}")
    for row in orders:
        if not row["good"]:
            lines.append(f"- order of {row['unknown']} ({row['norm']}), {order_case(row)}: "
                         f"{', '.join(map(short, row['orders']))}, bound {short(row.get('bound'))}")
    lines += [f"- {name} left no result" for name in absent]
    total = sum(len(record["checks"]) for record in records) + len(orders)
    return f"## Misses\n\n{total} checks.\n\n" + ("\n".join(map(shortened_case, lines)) if lines else "None.") + "\n"


def shortened_case(text):
    """Only numbers of floating-point prints: the others are names of cases."""
    return re.sub(r"-?\d\.\d+e[+-]\d+|-?\d+\.\d{4,}", lambda m: short(float(m[0])), text)


def order_case(row):
    """The case, and what of dimension, scheme and gas is not in its name."""
    more = [f"{row['dim']}-D"] if "dim" in row else []
    more += [row["scheme"]] if "scheme" in row else []
    more += [f"gas {row['gas']}"] if "gas" in row else []
    return ", ".join([row["case"], *more])


def order_section(rows):
    """A line for each case and unknown."""
    lines = {}
    for row in rows:
        steps = row.get("grids") or row["steps"]
        key = (order_case(row), "cells" if "grids" in row else "steps", tuple(steps), row["unknown"])
        lines.setdefault(key, {})["L2" if row["norm"] == "L2" else "max"] = row

    def orders(row):
        return ", ".join("-" if p is None else f"{p:.2f}" for p in row["orders"]) if row else ""

    def error(row):
        return short(row["errors"][-1]) if row else ""

    def bounds(norms):
        found = sorted({short(row["bound"]) for row in norms.values() if row.get("bound") is not None})
        return ", ".join(found) + ("" if all(row["good"] for row in norms.values()) else " **miss**")

    return table(["case", "unknown", "refined", "L2 error", "L2 orders", "greatest error", "its orders", "bound"],
                 [[key[0], key[3], f"{key[1]} {', '.join(map(str, key[2]))}", error(norms.get("L2")),
                   orders(norms.get("L2")), error(norms.get("max")), orders(norms.get("max")), bounds(norms)]
                  for key, norms in lines.items()]) if lines else ""


def check_section(records):
    parts = []
    for record in records:
        failed = sum(not check["good"] for check in record["checks"])
        total = len(record["checks"])
        count = f"{failed} of {total} checks missed" if failed else f"{total} checks hold"
        parts.append(f"## {', '.join(record['ids']) or record['script']}: {record['title']}\n\n"
                     f"`{record['script']}.py`, {count}.\n")
        parts.append(table(["quantity", "measured", "exact or bound"], merged(record["checks"])))
    return "\n".join(parts)


def merged(checks):
    """Rows of a table: what several runs of a script have in common as one row with the worst."""
    groups = {}
    for number, check in enumerate(checks):
        what = check["case"].rpartition(": ")[2]
        expected, _, _ = check["expected"].partition(" (off by")
        alike = check["good"] and "order" not in what and "last order" not in expected
        groups.setdefault((what, expected) if alike else number, []).append(check)
    rows = []
    for key, group in groups.items():
        worst = max(group, key=badness)
        case = group[0]["case"] if len(group) == 1 else f"{key[0]}, {len(group)} times"
        expected = worst["expected"].replace("<=", "≤").replace(">=", "≥").replace("+-", "±")
        mark = "" if worst["good"] else " **miss**"
        rows.append([shortened_case(case), shortened(worst["measured"]), shortened(expected) + mark])
    return rows


def badness(check):
    """How near a check is to its bound, among checks with the same one."""
    if check["expected"].startswith("<="):
        return float(check["measured"])
    if check["expected"].startswith(">="):
        return -float(check["measured"])
    off = re.search(r"off by (\S+)\)", check["expected"])
    return abs(float(off[1])) if off else 0


def hard_section(records, own, letter):
    """The lines of the scripts' hard cases, then the scripts and what of their checks holds; others in full."""
    lines = sorted((line for record in records for line in record["hard_cases"] if line["id"].startswith(letter)),
                   key=lambda line: id_key([line["id"]]))
    parts = []
    if lines:
        def span(line, low, high):
            return f"{short(line[low])} ... {short(line[high])}" if low in line else ""

        def number(line, name):
            return short(line[name]) if line.get(name) is not None else ""

        columns = [("id", lambda l: l["id"]), ("case", lambda l: l["title"]), ("steps", lambda l: l.get("steps", "")),
                   ("longest step [s]", lambda l: number(l, "dt_max")),
                   ("Newton per step", lambda l: number(l, "newton")), ("rejected", lambda l: l.get("rejected", "")),
                   ("nu", lambda l: span(l, "nu_min", "nu_max")), ("T [m2/s2]", lambda l: span(l, "T_min", "T_max")),
                   ("mass error", lambda l: number(l, "mass_error")),
                   ("mirror error", lambda l: number(l, "mirror_error")),
                   ("measured", lambda l: shortened_case(str(l.get("measured", "")))),
                   ("bound", lambda l: l.get("bound", "")),
                   ("without the remedy", lambda l: shortened_case(str(l.get("without", ""))))]
        columns = [(name, value) for name, value in columns if any(value(line) != "" for line in lines)]
        parts.append(table([name for name, _ in columns], [[value(line) for _, value in columns] for line in lines]))
    short_ones = [record for record in own if record["hard_cases"]]
    if short_ones:
        parts.append(table(["script", "ids", "what", "checks", "missed"],
                           [[f"`{r['script']}.py`", ", ".join(r["ids"]), r["title"], len(r["checks"]),
                             sum(not check["good"] for check in r["checks"])] for r in short_ones]))
    parts.append(check_section([record for record in own if not record["hard_cases"]]))
    return "\n".join(part for part in parts if part)


if __name__ == "__main__":
    main()
