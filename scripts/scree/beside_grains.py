"""Runs of a bin beside discrete elements of it: what is run, the reference data, the numbers to compare. Units cgs."""
import csv
from dataclasses import dataclass, field
from pathlib import Path

import numpy as np

from scree import output, program, slot_flow, sweeps
from scree.case_file import lengths


@dataclass(frozen=True)
class Model:
    """A run of a page: what it says of it, the case file, options against it."""

    name: str
    words: str
    case: str = "case.yaml"
    options: dict = field(default_factory=dict)

    def point(self, folder, work, shared=None):
        """The run in work / name; `folder` has the case, `shared` are options of all models."""
        found = sweeps.Point(folder / self.case, program.default_program(), 1, work, {}, {**(shared or {}), **self.options})
        found.name, found.directory = self.name, work / self.name
        return found


def run_missing(points, jobs):
    """Runs those that are not there yet."""
    missing = [point for point in points if point.state() == "missing"]
    for number, point in enumerate(sweeps.run_all(missing, jobs), 1):
        print(f"[{number}/{len(missing)}] {point.name}: {point.record()['reason'] or 'done'}", flush=True)


def read_csv(path):
    """The columns of a file of reference data: name -> list of texts."""
    with open(path) as file:
        rows = list(csv.DictReader(line for line in file if not line.startswith("#")))
    return {name: [row[name] for row in rows] for name in rows[0]}


def numbers(path, name):
    """The row of a run of discrete elements."""
    columns = read_csv(path)
    row = columns["run"].index(name)
    return {key: values[row] for key, values in columns.items()}


def flow(path):
    """The fields of discrete elements."""
    columns = {key: np.array(values, float) for key, values in read_csv(path).items()}
    x, y = np.unique(columns["x [cm]"]), np.unique(columns["y [cm]"])
    fields = [columns[key].reshape(len(y), len(x)) for key in ("nu", "vx [cm/s]", "vy [cm/s]", "T [cm2/s2]")]
    return slot_flow.Flow(faces_of(x), faces_of(y), *fields)


def faces_of(middles):
    """Faces of equal cells from their centres, a multiple of the size."""
    size = (middles[-1] - middles[0]) / (len(middles) - 1)
    return size * np.arange(round(middles[0] / size - 0.5), round(middles[-1] / size + 0.5) + 1)


class Run:
    """An output directory of the bin `silo`, heights from the floor; `reference` has the flow of its grains."""

    def __init__(self, directory, silo, reference):
        self.directory, self.silo, self.reference = Path(directory), silo, reference
        case = output.case(directory)
        floor = 100 * lengths(case["plate_floor_position"])[0]
        self.depth = 100 * lengths(case["output_depth"])[0]
        monitor = output.monitor(directory)
        self.time = output.time_of(monitor)
        # Backward Euler: the rate of a row is that of the step that ends there.
        self.mass = np.cumsum(1e3 * monitor["flux_orifice"] * np.diff(self.time, prepend=self.time[0]))
        self.rate = self.rate_in(silo.rate_window)
        self.fill_nu = float(case["initial_fill_solids_fraction"])
        at = output.fields_near(directory, silo.window[1])
        mean = "mean_" if "mean_velocity" in at else ""
        velocity = 100 * at[f"{mean}velocity"]
        self.flow = slot_flow.Flow(100 * at["x_faces"], 100 * at["y_faces"] - floor, at[f"{mean}solids_fraction"],
                                   velocity[..., 0], velocity[..., 1], 1e4 * at[f"{mean}granular_temperature"])
        self.plug = self.rate / (silo.density * self.fill_nu * silo.width * self.depth)
        self.summary = output.summary(directory)

    def rate_in(self, window):
        """Slope of the mass within a window of time [g/s]."""
        return slot_flow.slope(self.time, self.mass, window)

    def on_reference(self):
        """The fields as means over the cells of the discrete elements."""
        return self.flow.on(self.reference.x_faces, self.reference.y_faces)

    def row(self):
        """The numbers of a table, from fields on the cells of the discrete elements."""
        flow, rate = self.on_reference(), self.rate / self.depth
        return {
            "rate [g/s]": f"{self.rate:.1f}",
            "rate [g/s/cm]": f"{rate:.1f}",
            "C": f"{slot_flow.coefficient(rate, self.silo.density, self.fill_nu, self.silo.orifice):.3f}",
            "corner / plug": f"{flow.corner() / self.plug:.1e}",
            "shoulder angle [deg]": f"{flow.line_angle(self.plug):.0f}",
            "shoulder at 2 cm [cm]": f"{flow.line_at(self.plug, 2.0):.2f}",
            "shoulder height at the wall [cm]": f"{flow.height_at_wall(self.plug):.1f}",
            "nu over the orifice": f"{flow.above_orifice(flow.nu):.3f}",
            "T over the orifice [cm2/s2]": f"{flow.above_orifice(flow.temperature):.0f}",
            "cpu [s]": f"{self.summary['cpu_seconds']['total']:.0f}",
        }


def tidy(key, text):
    """The text of a number with the digits that pages show; none where there is no number."""
    digits = {"rate [g/s]": "{:.1f}", "rate [g/s/cm]": "{:.1f}", "shoulder angle [deg]": "{:.0f}",
              "shoulder height at the wall [cm]": "{:.1f}", "shoulder at 2 cm [cm]": "{:.1f}",
              "T over the orifice [cm2/s2]": "{:.0f}", "corner / plug": "{:.1e}"}
    if text == "nan":
        return ""
    return digits[key].format(float(text)) if key in digits and text else text
