"""check_pages.py on pages with one fault each: it names the fault, and nothing on a good page."""
import sys
import tempfile
from pathlib import Path

import check_pages

LONG = " ".join(["word"] * 26) + "."
FAULTS = {
    "a sentence of 26 words": LONG,
    "a sentence of 26 words ": f"| cell | {LONG} |",
    "a zero belongs before the point": "It takes .5 s.",
    "no such file": "See [there](nowhere.md).",
    "no such heading": "See [there](#nowhere).",
    "outside the repository": "See [there](../page.md).",
    "or Markdown changes it": r"The root $\{x\}$ is real.",
    "does not end": "```\ncode",
    "names scripts/gone.py": "`scripts/gone.py out`, `scripts/there.py`, scripts/plot_<case>.py.",
    "names scripts/gone": "```\nscripts/gone out\n```",
    "marked parts begin": "<!-- generated: options -->\ntext",
}
GOOD = f"# Heading\n\nSee [there](#heading), 0.5 s.\n\n    {LONG} .5\n\n```\n{LONG} .5\n```\n\nThe root $`\\{{x\\}}`$.\n"


def problems(folder, text):
    """What the checker prints for a repository with this page alone."""
    page = folder / "repository" / "README.md"
    (page.parent / "scripts").mkdir(parents=True, exist_ok=True)
    page.write_text(text)
    (folder / "page.md").write_text("beside the repository")
    (page.parent / "scripts" / "there.py").write_text("")
    root = page.parent.resolve()
    found = [*check_pages.link_problems(root, page.resolve(), text), *check_pages.block_problems(text),
             *check_pages.language_problems(text), *check_pages.maths_problems(text),
             *check_pages.script_problems(root, text)]
    return [problem for _, problem in found]


def main():
    failed = 0
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        (folder / "repository").mkdir()
        for expected, text in [("", GOOD), *FAULTS.items()]:
            found = problems(folder, text)
            good = found == [] if not expected else len(found) == 1 and expected.strip() in found[0]
            failed += not good
            print(f"{'ok  ' if good else 'FAIL'}  {text[:40]!r}: {found}")
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
