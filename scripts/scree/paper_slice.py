"""The bin of Srivastava & Sundaresan (2003), filled 10 cm high, beside a slice of it by discrete elements.

    scripts/why_c.py --slice [--work out/why_c] [--jobs N]

Runs the models of `MODELS` that are not there yet, and writes the table of cases/why_c/README.md. The reference data lie
in cases/why_c/reference; scripts/reference/discrete_elements.py made them. Units cgs."""
from pathlib import Path

from scree import beside_grains, page_tables
from scree.beside_grains import Model, Run, tidy
from scree.discrete_elements import PAPER, REFERENCES

ROOT = Path(__file__).resolve().parents[2]
BIN = ROOT / "cases" / "bin_discharge"
PAGE = ROOT / "cases" / "why_c"
REFERENCE = REFERENCES[PAPER.name]

#: Filled as high as the grains; fields hold means over the window of those of the grains.
FILL = {"initial_fill_box": "0, 4 cm, 5 cm, 15 cm", "end_time": PAPER.window[1], "output_average_from": PAPER.window[0],
        "output_interval": PAPER.window[1]}
MODELS = (
    Model("slice_paper", "the paper's model"),
    Model("slice_best", "best.yaml", "best.yaml"),
    Model("slice_best_dissipation", "best.yaml, friction in collisions", "best.yaml", {"particle_friction": 0.3}),
)
SHOWN = ("rate [g/s/cm]", "C", "corner / plug", "shoulder angle [deg]", "shoulder at 2 cm [cm]",
         "shoulder height at the wall [cm]", "nu over the orifice", "T over the orifice [cm2/s2]")


def reference_flow():
    """The fields of discrete elements."""
    return beside_grains.flow(REFERENCE / f"fields_{PAPER.name}.csv")


def table(rows):
    """rows: what the page says -> the numbers; a table of Markdown."""
    return page_tables.markdown(["", *SHOWN],
                                [[words, *(tidy(name, found[name]) for name in SHOWN)] for words, found in rows.items()])


def main(work, jobs):
    points = [(model, model.point(BIN, work, FILL)) for model in MODELS]
    beside_grains.run_missing([point for _, point in points], jobs)
    reference = reference_flow()
    rows = {"discrete elements": beside_grains.numbers(REFERENCE / f"{PAPER.name}.csv", PAPER.name)}
    rows.update({model.words: Run(point.directory, PAPER, reference).row() for model, point in points
                 if point.state() == "done"})
    page_tables.put(PAGE / "README.md", {"slice": table(rows)})
