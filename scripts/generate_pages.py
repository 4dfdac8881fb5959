#!/usr/bin/env python3
"""Writes the generated parts of the pages from what the program says of itself (scree -print_options, -help), and
checks the tables of boundary kinds.

    scripts/generate_pages.py            # writes
    scripts/generate_pages.py --check    # writes nothing; names what is not up to date, exit code 1

A generated part stands between <!-- generated: NAME --> and <!-- end -->, NAME being symbols or options. A table
between <!-- kinds: NAME --> and <!-- end --> is written by hand; its first column is to name each kind of boundary."""
import argparse
import os
import re
import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]
PAGES = ("src/MODEL.md", "cases/OPTIONS.md", "cases/GUIDE.md")
UNKNOWNS = ("", "nu", "v", "u", "T", "chi", "p_g")  # and what has no symbol
BUILD = Path(os.environ.get("SCREE_BUILD_DIR", ROOT / "build"))


def said(program, option):
    return subprocess.run([program, option], capture_output=True, text=True, check=True).stdout


def cells(row):
    """The cells of a row of a table in Markdown, bars within them still escaped."""
    return [cell.strip() for cell in re.split(r"(?<!\\)\|", row)[1:-1]]


def option_table(text):
    """The rows of scree -print_options as dicts by column; option names without backquotes."""
    rows = [line for line in text.splitlines() if line.startswith("|")]
    header = cells(rows[0])
    options = [dict(zip(header, cells(row))) for row in rows[2:]]
    for option in options:
        option["option"] = option["option"].strip("`")
    return options


def groups(text):
    """Option -> heading that scree -help puts it under."""
    heading, found = "", {}
    for line in text.splitlines():
        option = re.match(r"  -(\S+) ", line)
        if option:
            found[option[1]] = heading
        elif line and not line.startswith(" "):
            heading = line.strip()
    return found


def escaped(text):
    """A text whose <name> is no HTML, but for what stands in backquotes."""
    return re.sub(r"`[^`]*`|<", lambda match: match[0] if len(match[0]) > 1 else "&lt;", text)


def table(header, rows):
    return "\n".join(["| " + " | ".join(header) + " |", "|" + "---|" * len(header),
                      *("| " + " | ".join(map(escaped, row)) + " |" for row in rows)])


def symbols(options, _):
    """Parameters with a symbol that are numbers; those of sides, plates and regions repeat them."""
    rows = [(f"`{o['symbol']}`", o["meaning"], f"`{o['option']}`", o["unit"], o["default"])
            for o in options
            if o["symbol"] not in UNKNOWNS and o["allowed"] != "yes, no" and "<name>" not in o["option"]]
    return table(("symbol", "meaning", "option", "unit", "default"), rows)


def all_options(options, group_of):
    parts = []
    for group in dict.fromkeys(group_of[o["option"]] for o in options):
        rows = [(f"`{o['option']}`", o["unit"], o["default"], o["allowed"], o["meaning"])
                for o in options if group_of[o["option"]] == group]
        parts.append(f"### {escaped(group)}\n\n" + table(("option", "unit", "default", "allowed", "meaning"), rows))
    return "\n\n".join(parts)


MAKERS = {"symbols": symbols, "options": all_options}


def kind_problems(name, text, options):
    """Tables of kinds whose first column is not what boundary_<name>_kind allows."""
    allowed = next(o["allowed"] for o in options if o["option"] == "boundary_<name>_kind").split(", ")
    for table_name, body in re.findall(r"<!-- kinds: (\w+) -->\n(.*?)<!-- end -->", text, re.S):
        found = [cells(row)[0].strip("`") for row in body.splitlines() if row.startswith("| `")]
        if sorted(found) != sorted(allowed):
            yield (f"{name}: the table of kinds '{table_name}' has {', '.join(found)}; "
                   f"the program has {', '.join(allowed)}")


def filled(text, options, group_of):
    def replace(match):
        if match[1] not in MAKERS:
            raise SystemExit(f"nothing makes a part '{match[1]}'; there are {', '.join(MAKERS)}")
        return f"<!-- generated: {match[1]} -->\n{MAKERS[match[1]](options, group_of)}\n<!-- end -->"

    return re.sub(r"<!-- generated: (\w+) -->\n.*?<!-- end -->", replace, text, flags=re.S)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--program", type=Path, default=BUILD / "bin" / "scree", help="the executable")
    parser.add_argument("--check", action="store_true", help="write nothing")
    given = parser.parse_args()
    if not given.program.exists():
        sys.exit(f"no program '{given.program}': scripts/build.sh builds it, --program names another")
    options, group_of = option_table(said(given.program, "-print_options")), groups(said(given.program, "-help"))
    problems = []
    for name in PAGES:
        path = ROOT / name
        old = path.read_text()
        new = filled(old, options, group_of)
        problems += kind_problems(name, old, options)
        if new != old and given.check:
            problems.append(f"{name} is not up to date: run scripts/generate_pages.py")
        elif new != old:
            path.write_text(new)
            print(f"wrote {name}")
    print("\n".join(problems) or "The generated parts are up to date.")
    return 1 if problems else 0


if __name__ == "__main__":
    sys.exit(main())
