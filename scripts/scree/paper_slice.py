"""The bin of Srivastava & Sundaresan (2003), filled 10 cm high, beside a slice of it by discrete elements.

    scripts/why_c.py --slice [--work out/why_c] [--jobs N]

Runs the models of `MODELS` that are not there yet, and writes the table of cases/why_c/README.md. The reference data lie
in cases/why_c/reference; scripts/reference/discrete_elements.py made them. Units cgs."""
import csv
import re
from dataclasses import dataclass, field
from pathlib import Path

import numpy as np

from scree import output, program, slot_flow, sweeps
from scree.case_file import lengths
from scree.discrete_elements import PAPER

ROOT = Path(__file__).resolve().parents[2]
BIN = ROOT / "cases" / "bin_discharge"
PAGE = ROOT / "cases" / "why_c"
REFERENCE = PAGE / "reference"
FILL_NU = 0.60

#: Filled as high as the grains; fields hold means over the window of those of the grains.
FILL = {"initial_fill_box": "0, 4 cm, 5 cm, 15 cm", "end_time": PAPER.window[1], "output_average_from": PAPER.window[0],
        "output_interval": PAPER.window[1]}


@dataclass(frozen=True)
class Model:
    """A run of the table: its directory, what the page says of it, the case file, options against it."""

    name: str
    words: str
    case: str = "best.yaml"
    options: dict = field(default_factory=dict)


MODELS = (
    Model("slice_paper", "the paper's model", "case.yaml"),
    Model("slice_best", "best.yaml"),
    Model("slice_best_dissipation", "best.yaml, friction in collisions", options={"particle_friction": 0.3}),
)
SHOWN = ("rate [g/s/cm]", "C", "corner / plug", "shoulder angle [deg]", "shoulder at 2 cm [cm]",
         "shoulder height at the wall [cm]", "nu over the orifice", "T over the orifice [cm2/s2]")


def point(model, work):
    found = sweeps.Point(BIN / model.case, program.default_program(), 1, work, {}, {**FILL, **model.options})
    found.name, found.directory = model.name, work / model.name
    return found


def read_csv(path):
    """The rows of a file of reference data."""
    with open(path) as file:
        return list(csv.DictReader(line for line in file if not line.startswith("#")))


def cells_of_reference():
    """Faces along x and y of the cells on which discrete elements have their fields."""
    rows = read_csv(REFERENCE / f"fields_{PAPER.name}.csv")
    faces = []
    for name in ("x [cm]", "y [cm]"):
        middles = np.unique([float(row[name]) for row in rows])
        size = (middles[-1] - middles[0]) / (len(middles) - 1)
        faces.append(size * np.arange(round(middles[0] / size - 0.5), round(middles[-1] / size + 0.5) + 1))
    return faces


def row(directory, x_faces, y_faces):
    """The numbers of a run, from fields on the given cells."""
    floor = 100 * lengths(output.case(directory)["plate_floor_position"])[0]
    monitor = output.monitor(directory)
    time = output.time_of(monitor)
    mass = np.cumsum(1e3 * monitor["flux_orifice"] * np.diff(time, prepend=time[0]))  # of a slab of 1 cm
    rate = slot_flow.slope(time, mass, PAPER.rate_window)
    plug = rate / (PAPER.density * FILL_NU * PAPER.width)
    fields = output.fields_near(directory, PAPER.window[1])
    velocity = 100 * fields["mean_velocity"]
    flow = slot_flow.Flow(100 * fields["x_faces"], 100 * fields["y_faces"] - floor, fields["mean_solids_fraction"],
                          velocity[..., 0], velocity[..., 1], 1e4 * fields["mean_granular_temperature"])
    flow = flow.on(x_faces, y_faces)
    return {
        "rate [g/s/cm]": f"{rate:.1f}",
        "C": f"{slot_flow.coefficient(rate, PAPER.density, FILL_NU, PAPER.orifice):.3f}",
        "corner / plug": f"{flow.corner() / plug:.1e}",
        "shoulder angle [deg]": f"{flow.line_angle(plug):.0f}",
        "shoulder at 2 cm [cm]": f"{flow.line_at(plug, 2.0):.2f}",
        "shoulder height at the wall [cm]": f"{flow.height_at_wall(plug):.1f}",
        "nu over the orifice": f"{flow.above_orifice(flow.nu):.3f}",
        "T over the orifice [cm2/s2]": f"{flow.above_orifice(flow.temperature):.1f}",
    }


def table(rows):
    """rows: what the page says -> the numbers; a table of Markdown."""
    lines = [["", *SHOWN], ["---"] * (len(SHOWN) + 1)]
    lines += [[words, *("" if found[name] == "nan" else found[name] for name in SHOWN)] for words, found in rows.items()]
    return "\n".join("| " + " | ".join(line) + " |" for line in lines)


def main(work, jobs):
    points = [(model, point(model, work)) for model in MODELS]
    missing = [found for _, found in points if found.state() == "missing"]
    for number, found in enumerate(sweeps.run_all(missing, jobs), 1):
        print(f"[{number}/{len(missing)}] {found.name}: {found.record()['reason'] or 'done'}", flush=True)
    rows = {"discrete elements": read_csv(REFERENCE / "paper.csv")[0]}
    faces = cells_of_reference()
    rows.update({model.words: row(found.directory, *faces) for model, found in points if found.state() == "done"})
    page = PAGE / "README.md"
    page.write_text(re.sub(r"(<!-- generated: slice -->\n).*?(<!-- end -->)",
                           lambda match: f"{match[1]}{table(rows)}\n{match[2]}", page.read_text(), flags=re.S))
