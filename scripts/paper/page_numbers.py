#!/usr/bin/env python3
"""The table of all numbers: the paper's, ours on its grid, extrapolated to fine cells, and what they cost. Runs
nothing: what is not there says so.

    scripts/paper/page_numbers.py          # OUT/numbers.md, OUT/numbers.csv
    scripts/paper/page_numbers.py --page   # and cases/paper/README.md from scripts/paper/page.md, with its pictures

In page.md {{figure_04.plateau}} stands for a number on the paper's grid, {{figure_04.plateau:half}} for one on another
grid, {{figure_04.plateau:limit}} for the extrapolated one with its uncertainty, {{figure_04.plateau:order}} for its
order, {{cost:figure_04}} for the time of the runs of a section, {{cost:all}} for that of all runs,
{{table:figure_04}} for the table of all numbers of a section, {{grids:convergence}} for that table on all grids."""
import math
import re
import shutil
from pathlib import Path

import paper_figures
import paper_quantities
import paper_runs

from scree.program import clock

PAGE = Path(__file__).with_name("page.md")
PICTURES = paper_runs.CASES / "paper"
PICTURE_BYTES = 300_000
NOT_RUN = "not run"
HEAD = ["what", "paper", "Scree", "half the cells", "extrapolated", "against the paper", "CPU s"]
TITLES = {"figures": "Figures", "claims": "Claims of the text", "findings": "Findings beyond the paper",
          "convergence": "Grids"}


def table(header, rows):
    """A table in Markdown."""
    lines = [header, ["---"] * len(header), *rows]
    return "\n".join("| " + " | ".join(line) + " |" for line in lines)


def labelled(quantity):
    return quantity.what + (f" [{quantity.unit}]" if quantity.unit else "")


class Numbers:
    """Values of all quantities as text; "ours" are those on `grid`."""

    def __init__(self, values, grid):
        self.values, self.grid = values, grid
        self.by_key = {quantity.key: quantity for group in paper_quantities.SECTIONS.values() for quantity in group}

    def own_grid(self, quantity):
        """The grid of "ours"; parameters are on the coarse one."""
        return paper_runs.TABLE[quantity.runs[0]].page[0] if quantity.section == "parameters" else self.grid

    def value(self, quantity, grid):
        value = self.values.value(quantity, grid)
        return NOT_RUN if value is None else quantity.text(value) or "none"

    def limit(self, quantity):
        limit = self.values.limit(quantity)
        if not limit:
            return "" if not quantity.grids else NOT_RUN
        form = quantity.form
        return f"{limit.value:{form}} ± {limit.doubt:{form}} ({limit.how})"

    def difference(self, quantity):
        """Ours against the paper's number, where it gives one [%]."""
        number = re.fullmatch(r"(?:about )?(\d+\.?\d*)", quantity.paper)
        value = self.values.value(quantity, self.own_grid(quantity))
        if not number or value is None or not math.isfinite(value):
            return ""
        return f"{100 * (value / float(number[1]) - 1):+.1f} %"

    def row(self, quantity):
        grid = self.own_grid(quantity)
        cpu = self.values.cpu(quantity, grid) if self.values.value(quantity, grid) is not None else math.nan
        half = quantity.text(self.values.value(quantity, "half"))
        return [labelled(quantity), quantity.paper, self.value(quantity, grid), half, self.limit(quantity),
                self.difference(quantity), f"{cpu:.0f}" if math.isfinite(cpu) else ""]

    def section(self, name):
        """The table of a section, such as figure_04."""
        rows = [self.row(quantity) for quantity in self.by_key.values() if quantity.section == name]
        shown = [column for column in range(len(HEAD)) if column < 3 or any(row[column] for row in rows)]
        return table([HEAD[column] for column in shown], [[row[column] for column in shown] for row in rows])

    def grids(self, name):
        """The table of a section on all grids; blank where the page does not want a number."""
        def cell(quantity, grid):
            entries = [paper_runs.TABLE[run] for run in quantity.runs]
            wanted = all(grid in entry.page and entry.end_time(grid) >= quantity.until for entry in entries)
            return self.value(quantity, grid) if wanted else ""

        rows = [[labelled(quantity), *(cell(quantity, grid) for grid in paper_runs.GRIDS), self.limit(quantity)]
                for quantity in self.by_key.values() if quantity.section == name]
        return table(["what", *paper_runs.GRIDS, "extrapolated"], rows)

    def cost(self, name):
        """The time of the runs of a section, or of all runs of the page, as far as they are there."""
        if name == "all":
            needed = paper_runs.page_runs()
        else:
            needed = {(paper_runs.TABLE[run], self.own_grid(quantity)) for quantity in self.by_key.values()
                      if quantity.section == name for run in quantity.runs}
        costs = [self.values.runs.cost(entry, grid) for entry, grid in needed]
        costs = [cost for cost in costs if cost["cpu"]]
        if not costs:
            return NOT_RUN
        text = f"{sum(cost['cpu'] for cost in costs):.0f} CPU s, {clock(sum(cost['wall'] for cost in costs))}"
        missing = len(needed) - len(costs)
        return f"{text}; {missing} of {len(needed)} runs {NOT_RUN}" if missing else text

    def named(self, text):
        """What {{text}} on the page stands for."""
        kind, _, name = text.partition(":")
        sections = {"table": self.section, "grids": self.grids, "cost": self.cost}
        if kind in sections:
            if text != "cost:all" and not any(quantity.section == name for quantity in self.by_key.values()):
                raise paper_runs.Problem(f"{PAGE.name}: no section {name} for {{{{{text}}}}}")
            return sections[kind](name)
        if kind not in self.by_key:
            raise paper_runs.Problem(f"{PAGE.name}: no quantity {kind} for {{{{{text}}}}}")
        quantity = self.by_key[kind]
        if name == "order":
            limit = self.values.limit(quantity)
            return f"{limit.order:.2f}" if limit and limit.regular else NOT_RUN
        if name == "limit":
            return self.limit(quantity) or NOT_RUN
        if name and name not in paper_runs.GRIDS:
            choices = ", ".join((*paper_runs.GRIDS, "limit", "order"))
            raise paper_runs.Problem(f"{PAGE.name}: {{{{{text}}}}}: {name} is none of {choices}")
        return self.value(quantity, name or self.own_grid(quantity))

    def markdown(self):
        """All tables."""
        lines = ["# The numbers of the paper and ours", "",
                 f"Scree: on the grid '{self.grid}', parameters on the coarse one. Extrapolated: from the three finest "
                 "grids that there are. Runs that serve several rows are counted in each."]
        for group, quantities in paper_quantities.SECTIONS.items():
            lines += ["", f"## {TITLES[group]}"]
            for name in dict.fromkeys(quantity.section for quantity in quantities):
                lines += ["", f"### {name}: {self.cost(name)}", "", self.section(name)]
        return "\n".join(lines) + "\n"

    def data(self):
        """Header and rows of numbers.csv."""
        header = ["key", "what", "unit", "paper's", *paper_runs.GRIDS, "extrapolated", "uncertainty", "order",
                  "order seen", "cpu [s]"]
        rows = []
        for quantity in self.by_key.values():
            on_grids, limit = self.values.on_grids(quantity), self.values.limit(quantity)
            ends = (limit.value, limit.doubt, limit.order, "yes" if limit.regular else "no") if limit else [""] * 4
            cpu = self.values.cpu(quantity, self.own_grid(quantity))
            rows.append((quantity.key, quantity.what, quantity.unit, quantity.paper,
                         *(on_grids.get(grid, "") for grid in paper_runs.GRIDS), *ends, cpu))
        return header, rows


def filled(numbers, text):
    """The page, and how many of its numbers are not there yet."""
    page = re.sub(r"\{\{(.+?)\}\}", lambda found: numbers.named(found[1]), text)
    return page, page.count(NOT_RUN)


def take_pictures(page, out):
    """Copies the pictures that the page shows; those not drawn yet stay as they are."""
    PICTURES.mkdir(exist_ok=True)
    for name in dict.fromkeys(re.findall(r"\(([\w.]+\.png)\)", page)):
        if not (out / name).exists():
            print(f"  {out / name} is not there")
        elif (out / name).stat().st_size > PICTURE_BYTES:
            raise paper_runs.Problem(f"{out / name} has more than {PICTURE_BYTES // 1000} kB")
        else:
            shutil.copyfile(out / name, PICTURES / name)


def main():
    page = ("--page", dict(action="store_true", help="write cases/paper/README.md too"))
    given = paper_runs.arguments(__doc__, more=[page])
    values = paper_quantities.Values(given.runs, given.out)
    numbers = Numbers(values, given.grid)
    text = numbers.markdown()
    values.keep()
    given.out.mkdir(parents=True, exist_ok=True)
    (given.out / "numbers.md").write_text(text)
    paper_figures.write_csv(given.out / "numbers.csv", *numbers.data())
    print(f"  {given.out / 'numbers'}.md, .csv")
    if given.page:
        page, missing = filled(numbers, PAGE.read_text())
        take_pictures(page, given.out)
        (PICTURES / "README.md").write_text(page)
        print(f"  {PICTURES / 'README.md'}" + (f": {missing} numbers not run" if missing else ""))


if __name__ == "__main__":
    paper_runs.guarded(main)
