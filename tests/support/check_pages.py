#!/usr/bin/env python3
"""Checks the pages: sentences of at most 25 words, a zero before the decimal point, links to files and headings that
exist. Blocks of code and maths, and the blocks that scripts generate, are not read as sentences. Pages that sources
name, in comments or elsewhere, exist too, and so do the files `scripts/...` that pages or sources name.

Usage: check_pages.py [--figures] [SOURCE_DIRECTORY]     (default: the checkout that this file is in)

--figures prints for each page the sentences outside of tables, their mean and their greatest length in words."""
import re
import subprocess
import sys
from pathlib import Path

MOST_WORDS = 25
#: Written by scripts from what tests measured: they may hold maths that Markdown changes.
MEASURED = ("tests/results/", "tests/benchmark/")

#: Pages that scripts write into their output.
WRITTEN = ("choice.md", "numbers.md")
SOURCES = ("*.hpp", "*.cpp", "*.py", "*.sh", "*.yaml", "*.txt", "*Dockerfile", ".ci/run")

FENCE = re.compile(r"^ {0,3}(```|~~~)")
GENERATED = re.compile(r"^<!-- generated: .*-->$")
GENERATED_END = "<!-- end -->"
ABBREVIATIONS = re.compile(r"\b(?:e\.g|i\.e|etc|vs|Figs?|al|No|Technol)\.(?=\s)")
#: In $...$ Markdown takes these for its own; in $`...`$ they are safe.
UNSAFE_MATHS = re.compile(r"\$[^$`]*(?:\\[,;:!{}|%#]|\*)[^$`]*\$")
#: A file beneath scripts/; a name with a gap such as plot_<case>.py is none.
SCRIPT = re.compile(r"(?<![\w./-])scripts/[\w./-]*\w(?![\w./-]*[<{*$])")
CITED = re.compile(r"\w[\w./-]*\.md\b")
BARE_DECIMAL = re.compile(r"(?<![\w.)])\.\d")
LINK = re.compile(r"!?\[[^\]]*\]\(([^)\s]+)\)")


class Line:
    """A line of a page that is prose: its number and text."""

    def __init__(self, number, text):
        self.number, self.text = number, text


def prose(text):
    """The lines of a page without code, maths and generated blocks; those are empty, so that they end a sentence."""
    fenced = generated = False
    for number, line in enumerate(text.splitlines(), 1):
        if FENCE.match(line):
            fenced = not fenced
            line = ""
        elif GENERATED.match(line.strip()):
            generated = True
        elif line.strip() == GENERATED_END:
            generated = False
        indented = line.startswith("    ") and not line.lstrip().startswith(("-", "*"))
        yield Line(number, "" if fenced or generated or indented or line.startswith("<!--") else line)


def plain(text):
    """A text as it is read: what stands in code, maths and links counts as one word, or as its words."""
    text = re.sub(r"!\[[^\]]*\]\([^)]*\)", " ", text)
    text = re.sub(r"`[^`]*`", " code ", text)
    text = re.sub(r"\$[^$]*\$", " maths ", text)
    text = re.sub(r"\[([^\]]*)\]\([^)]*\)", r"\1", text)
    return ABBREVIATIONS.sub(lambda match: match[0][:-1], text)


def pieces(lines):
    """(number, text) of what can hold sentences: a paragraph, an item of a list, a heading, a cell of a table."""
    number, parts = 0, []
    for line in [*lines, Line(0, "")]:
        text = line.text.strip()
        starts = text.startswith(("|", "#", "- ", "* ", ">")) or re.match(r"\d+\. ", text)
        if parts and (not text or starts):
            yield number, " ".join(parts)
            parts = []
        if text.startswith("|"):
            for cell in re.split(r"(?<!\\)\|", text):
                yield line.number, cell
        elif text.startswith("#"):
            yield line.number, text
        elif text:
            number = number if parts else line.number
            parts.append(re.sub(r"^(?:[-*>]|\d+\.) ", "", text))


def sentences(text, tables=True):
    """(number, words) of the sentences of a page, without its tables if they are not wanted."""
    lines = (line for line in prose(text) if tables or not line.text.startswith("|"))
    for number, piece in pieces(lines):
        for sentence in re.split(r"(?<=[.!?])\s+", plain(piece)):
            words = [word for word in sentence.split() if re.search(r"\w", word)]
            if words:
                yield number, words


def anchors(path):
    """The anchors that GitHub gives to the headings of a page."""
    found = set()
    for line in prose(path.read_text()):
        heading = re.match(r"#+ (.*)", line.text)
        if heading:
            words = re.sub(r"[^\w\- ]", "", re.sub(r"[`*]", "", heading[1]).lower())
            found.add(words.strip().replace(" ", "-"))
    return found


def link_problems(root, path, text):
    for line in prose(text):
        for target in LINK.findall(line.text):
            if re.match(r"[a-z]+:", target):
                continue
            name, _, anchor = target.partition("#")
            page = (path.parent / name).resolve() if name else path
            if not page.exists():
                yield line.number, f"link to {target}: no such file"
            elif root not in page.parents and page != root:
                yield line.number, f"link to {target}: outside the repository"
            elif anchor and page.suffix == ".md" and anchor not in anchors(page):
                yield line.number, f"link to {target}: no such heading"


def language_problems(text):
    for number, words in sentences(text):
        if len(words) > MOST_WORDS:
            yield number, f"a sentence of {len(words)} words, at most {MOST_WORDS}: {' '.join(words[:8])} ..."
    for line in prose(text):
        bare = BARE_DECIMAL.search(re.sub(r"`[^`]*`", "", line.text))
        if bare:
            around = line.text[max(0, bare.start() - 10):bare.end() + 10]
            yield line.number, f"a zero belongs before the point: {around}"


def citation_problems(root, names):
    """Pages that a source names although the repository has none of that name."""
    for path in files(root, *SOURCES):
        if path.name.startswith("check_pages"):  # itself and its test
            continue
        for number, line in enumerate(path.read_text().splitlines(), 1):
            for cited in CITED.findall(line):
                if Path(cited).name not in WRITTEN and not any(f"/{name}".endswith(f"/{cited}") for name in names):
                    yield f"{path.relative_to(root)}:{number}: names {cited}, which is not in the repository"


def script_problems(root, text):
    """Files of scripts/ that a page or a source names although they are not there."""
    for number, line in enumerate(text.splitlines(), 1):
        for cited in SCRIPT.findall(line):
            if not (root / cited).exists():
                yield number, f"names {cited}, which is not in the repository"


def block_problems(text):
    """Blocks that do not end: what follows them would be read as code."""
    fences = [number for number, line in enumerate(text.splitlines(), 1) if FENCE.match(line)]
    if len(fences) % 2:
        yield fences[-1], "this block of code does not end"
    starts = [line for line in text.splitlines() if re.match(r"<!-- (generated|kinds|checked): ", line)]
    if len(starts) != text.splitlines().count(GENERATED_END):
        yield 1, f"{len(starts)} marked parts begin, {text.splitlines().count(GENERATED_END)} end"


def maths_problems(text):
    for line in prose(text):
        unsafe = UNSAFE_MATHS.search(line.text)
        if unsafe:
            yield line.number, f"write {unsafe[0]} as $`...`$, or Markdown changes it"


def files(root, *patterns):
    """The tracked files; where this is no git checkout, those beneath the folders of the repository."""
    try:
        git = subprocess.run(["git", "-C", root, "ls-files", *patterns], capture_output=True, text=True, check=True)
        return [root / line for line in git.stdout.splitlines() if (root / line).exists()]
    except (OSError, subprocess.CalledProcessError):
        places = (root / folder for folder in ("cases", "src", "include", "tests", "scripts", "docker"))
        below = [place.rglob(Path(pattern).name) for place in places for pattern in patterns]
        return sorted({*(path for found in below for path in found), *(p for q in patterns for p in root.glob(q))})


def measured(name):
    """Whether a script wrote the page from what tests measured."""
    return name.startswith(MEASURED) and not name.endswith("/notes.md")


def main():
    arguments = sys.argv[1:]
    if arguments[:1] in (["-h"], ["--help"]):
        print(__doc__)
        return 0
    figures = "--figures" in arguments
    arguments = [argument for argument in arguments if argument != "--figures"]
    root = Path(arguments[0] if arguments else Path(__file__).parents[2]).resolve()
    problems = []
    pages = files(root, "*.md")
    problems += citation_problems(root, [str(page.relative_to(root)) for page in pages])
    for path in files(root, *SOURCES, "*.md"):
        if not path.name.startswith("check_pages"):
            problems += [f"{path.relative_to(root)}:{number}: {problem}"
                         for number, problem in script_problems(root, path.read_text())]
    for path in pages:
        name, text = str(path.relative_to(root)), path.read_text()
        if name.endswith("/page.md"):  # a form that a script fills in
            continue
        found = [*link_problems(root, path, text), *block_problems(text)]
        found += language_problems(text)
        if not measured(name):
            found += maths_problems(text)
        problems += [f"{name}:{number}: {problem}" for number, problem in sorted(found)]
        if figures:
            lengths = [len(words) for _, words in sentences(text, tables=False)]
            print(f"{name}: {len(lengths)} sentences, mean {sum(lengths) / max(len(lengths), 1):.1f}, "
                  f"longest {max(lengths, default=0)}")
    print("\n".join(problems) or "The pages are in order.")
    return 1 if problems else 0


if __name__ == "__main__":
    sys.exit(main())
