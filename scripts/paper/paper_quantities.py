"""The numbers of the page: for each what it is, the paper's, the runs that it comes from and how it is read off them;
and its value on each grid, with observed order and extrapolation."""
import functools
import json
import math
import os
from dataclasses import dataclass
from pathlib import Path

import paper_runs
from paper_figures import Discharge, discharges
from paper_runs import GRIDS, STEADY, TABLE

import numpy as np

import figure_06
import figure_09
import flutter
import parameters
from scree import bubble_rise, output, quantities
import starts
from scree.bin_discharge import DEPTH_TIMES
from scree.work_precision import CORRECTION_DOUBT, ORDER_RANGE, Series, extrapolated

EARLY, PLATEAU, FINE = (0.3, 0.5), (1.0, 2.0), TABLE["fine_air"].window  # [s]
NU, CHI, P_G = "solids_fraction", "frictional_pressure_ratio", "gas_pressure"
PASCAL = 10.0  # [dyn/cm2]


@dataclass(frozen=True)
class Quantity:
    """read(directories of `runs`) gives the number, from runs that reach `until` [s]. paper: its number as text, or
    ""."""

    key: str
    what: str
    unit: str
    paper: str
    runs: tuple
    until: float
    read: object
    form: str = ".1f"
    grids: bool = True  # whether it has a limit of fine cells that is worth extrapolating to

    @property
    def section(self):
        return self.key.split(".")[0]

    def text(self, value):
        return "" if value is None or not math.isfinite(value) else format(value, self.form)


# ---- reading ----


@functools.lru_cache(maxsize=None)
def bubble(directory):
    """bottom, top, width, area of the bubble at the end."""
    return {name: float(value[0]) for name, value in quantities.bubble_quantities(directory, None).items()}


def rise(directory, begin=0.4, end=0.5):
    """Mean speed of the bubble's top between two times [cm/s]."""
    states = [output.fields_near(directory, time) for time in (begin, end)]
    tops = [bubble_rise.bubble(state)["top"] for state in states]
    return (tops[1] - tops[0]) / (states[1]["time"] - states[0]["time"])


def rate(window):
    return lambda directory: Discharge(directory).mean_rate(window)


def rate_at(time):
    return lambda directory: Discharge(directory).rate_at(time)


def in_plane(name, window):
    return lambda directory: Discharge(directory).mean_in_orifice_plane(name, window)


def on_axis(name, height, window):
    """Mean on the centreline at a height over the orifice [cm]."""

    def read(directory):
        run = Discharge(directory)
        return float(np.interp(height, run.y, run.mean_centreline(name, window)))

    return read


def drop_of_chi(directory):
    """How far chi falls from high up to the orifice plane [%]."""
    return 100 * (1 - in_plane(CHI, STEADY)(directory) / on_axis(CHI, 20.0, STEADY)(directory))


def jet(distance, what):
    """nu on the centreline of the jet below the orifice, or the half width at half of it [cm]."""

    def read(directory):
        run = Discharge(directory, STEADY)
        nu = figure_06.profiles(run)[distance]
        return nu[0] if what == "nu" else float(np.interp(-0.5 * nu[0], -nu, run.x))  # nu falls outwards

    return read


def per_cent(a, b):
    """How far a is from b."""
    return 100 * (a / b - 1)


def rates_apart(window):
    """By how much the rate of the second run differs from that of the first [%]."""
    return lambda first, second: per_cent(rate(window)(second), rate(window)(first))


def spread_of_rates(window):
    """Greatest over least plateau rate [%]."""

    def read(*directories):
        rates = [rate(window)(directory) for directory in directories]
        return per_cent(max(rates), min(rates))

    return read


def profiles_apart(window):
    """Greatest difference of nu on the centreline, 5 cm below to 20 cm above the orifice."""

    def read(*directories):
        first, second = (quantities.profile(run, run.mean(NU)) for run in discharges(directories, window))
        return float(np.abs(first - second).max())

    return read


def depth_at(time):
    return lambda directory: Discharge(directory).depth_at(time)


def corner(directory):
    """Mean speed within 1 cm of the corner over that of the plug 40 cm up, at the instant of Figure 5 [%]."""
    run = Discharge(directory, at=3.0)
    speed = np.hypot(run.velocity[..., 0], run.velocity[..., 1])
    cells = np.ix_((run.y > 0) & (run.y < 1), run.x > run.x_faces[-1] - 1)
    return 100 * speed[cells].mean() / row_at(run, 40.0).mean()


def plug(directory):
    """By how much the centreline is faster than the wall 40 cm up, over the mean [%]."""
    speed = row_at(Discharge(directory, at=3.0), 40.0)
    return 100 * (speed[0] - speed[-1]) / speed.mean()


def flat_part(directory):
    """Share of the width 40 cm up in which the speed is within 10 % of the centreline's [%]."""
    run = Discharge(directory, at=3.0)
    speed = row_at(run, 40.0)
    return 100 * float(np.interp(-0.9 * speed[0], -speed, run.x)) / run.x_faces[-1]  # speed falls outwards


def row_at(run, height):
    return -run.velocity[np.argmin(np.abs(run.y - height)), :, 1]


def deficit(what):
    """Least p_g on the centreline over the outside [dyn/cm2], or its height [cm]."""

    def read(directory):
        run = Discharge(directory)
        p_g = run.mean_centreline(P_G, FINE)
        lowest = np.argmin(p_g)
        return PASCAL * p_g[lowest] if what == "pressure" else run.y[lowest]

    return read


def start_swing(directory):
    return starts.swing(Discharge(directory))


def starts_agree(*directories):
    return starts.same_from([Discharge(directory) for directory in directories])


def derivative(parameter, what):
    def read(*directories):
        found = parameters.derivatives_of(parameter, dict(zip(parameter_runs(parameter), directories)))
        return found[what]

    return read


def parameter_runs(parameter):
    return (parameters.BASE, parameters.TIGHT, *(parameter.entry(steps).name for steps in paper_runs.DIFFERENCES))


# ---- the table ----

BIN = ("bin",)
BUBBLES = {model: f"bubble_{model}" for model in ("relaxed", "critical_state", "no_friction")}
BUBBLE_ENDS = {"bottom": "cm", "top": "cm", "width": "cm", "area": "cm2"}


def of_figures():
    q = Quantity
    widths = tuple(paper_runs.WIDTHS.values())
    found = [
        q("figure_04.plateau", "plateau rate, τ = 10⁻³ s, 1.5 to 4.5 s", "g/s", "about 144", BIN, 4.5, rate(STEADY)),
        q("figure_04.plateau_tau_1e-2", "the same, τ = 10⁻² s", "g/s", "about 144", ("bin_tau_1e-2",), 4.5,
          rate(STEADY)),
        q("figure_04.plateau_tau_1e-1", "the same, τ = 10⁻¹ s", "g/s", "about 144", ("bin_tau_1e-1",), 4.5,
          rate(STEADY)),
        q("figure_04.spread", "greatest over least of the three", "%", "not much",
          ("bin", "bin_tau_1e-2", "bin_tau_1e-1"), 4.5, spread_of_rates(STEADY), ".2f", False),
    ]
    for time in (1.0, 5.9):
        found.append(q(f"figure_04.rate_at_{time:g}", f"rate at {time:g} s", "g/s", "", BIN, time, rate_at(time)))
    found += [
        q("figure_05.plug", "40 cm up, centreline faster than wall", "% of mean", "nearly plug flow", BIN, 3.0, plug),
        q("figure_05.flat", "width within 10 % of the centreline's speed", "% of all", "nearly plug flow", BIN, 3.0,
          flat_part),
        q("figure_05.corner", "speed within 1 cm of the corner over the plug's", "%", "slow, not stagnant", BIN, 3.0,
          corner),
    ]
    for distance in figure_06.BELOW:
        found += [q(f"figure_06.nu_{distance:g}", f"ν on the centreline {distance:g} cm below", "", "", BIN, 4.5,
                    jet(distance, "nu"), ".3f"),
                  q(f"figure_06.half_width_{distance:g}", "half width at half of it", "cm", "", BIN, 4.5,
                    jet(distance, "width"), ".3f")]
    found += [
        q("figure_07.high_up", "ν on the centreline 20 cm up", "", "0.60", BIN, 4.5, on_axis(NU, 20.0, STEADY), ".3f"),
        q("figure_07.plane", "ν in the orifice plane", "", "0.52", BIN, 4.5, in_plane(NU, STEADY), ".3f"),
        q("figure_07.critical_state", "the same, critical state", "", "0.52", ("bin_critical_state",), 4.5,
          in_plane(NU, STEADY), ".3f"),
        q("figure_07.air", "the same, with air, 1 to 2 s", "", "0.52", ("bin_air",), 2.0, in_plane(NU, PLATEAU), ".3f"),
        q("figure_08.high_up", "χ on the centreline 20 cm up", "", "very close to 1", BIN, 4.5,
          on_axis(CHI, 20.0, STEADY), ".3f"),
        q("figure_08.plane", "χ in the orifice plane", "", "about 0.9", BIN, 4.5, in_plane(CHI, STEADY), ".3f"),
        q("figure_08.drop", "drop of χ", "%", "about 10", BIN, 4.5, drop_of_chi),
    ]
    for width, name in paper_runs.WIDTHS.items():
        found.append(q(f"figure_09.rate_{width}", f"rate at D_o = {width} cm, 1 to 2 s", "g/s",
                       "about 144" if width == "1.4" else "", (name,), 2.0, rate(PLATEAU)))
    found += [
        q("figure_09.exponent", "exponent of W ~ D_o^m", "", "1.4", widths, 2.0,
          lambda *directories: figure_09.fit(figure_09.rates(directories))[0], ".3f"),
        q("figure_09.C", "C of (28), mean of the widths", "", "about 1.6", widths, 2.0, mean_c, ".3f"),
        q("figure_10.vacuum", "rate without air, 0.6 to 1.2 s", "g/s", "almost that of 1 mm", ("fine_vacuum",), 1.2,
          rate(FINE)),
        q("figure_10.air", "rate with air, 0.6 to 1.2 s", "g/s", "significantly lower", ("fine_air",), 1.2, rate(FINE)),
        q("figure_10.ratio", "with air against without", "%", "", ("fine_vacuum", "fine_air"), 1.2, rates_apart(FINE)),
        q("figure_11.plane_vacuum", "ν in the orifice plane without air", "", "", ("fine_vacuum",), 1.2,
          in_plane(NU, FINE), ".3f"),
        q("figure_11.plane_air", "the same with air", "", "changes less", ("fine_air",), 1.2, in_plane(NU, FINE),
          ".3f"),
        q("figure_11.below_vacuum", "ν 4 cm below without air", "", "", ("fine_vacuum",), 1.2, on_axis(NU, -4.0, FINE),
          ".3f"),
        q("figure_11.below_air", "the same with air", "", "changes less", ("fine_air",), 1.2, on_axis(NU, -4.0, FINE),
          ".3f"),
        q("figure_12.deficit", "least p_g on the centreline", "dyn/cm²", "sub-atmospheric", ("fine_air",), 1.2,
          deficit("pressure"), ".0f"),
        q("figure_12.height", "its height over the orifice", "cm", "just above", ("fine_air",), 1.2, deficit("height")),
        *(q(f"figure_13.{model}_{end}", f"{model.replace('_', ' ')}: {end} at 0.5 s", unit.replace("2", "²"), "",
            (name,), 0.5,
            lambda directory, end=end: bubble(directory)[end])
          for model, name in BUBBLES.items() for end, unit in BUBBLE_ENDS.items()),
        *(q(f"figure_13.{model}_rise", f"{model.replace('_', ' ')}: speed of the top, 0.4 to 0.5 s", "cm/s", "",
            (name,), 0.5, rise)
          for model, name in BUBBLES.items()),
    ]
    return found


def mean_c(*directories):
    return float(np.mean([figure_09.beverloo(width, rate) for width, rate in figure_09.rates(directories).items()]))


def of_claims():
    q = Quantity
    area = lambda first, second: per_cent(bubble(second)["area"], bubble(first)["area"])
    elongation = lambda directory: (bubble(directory)["top"] - bubble(directory)["bottom"]) / bubble(directory)["width"]
    fall = lambda directory: depth_at(1.5)(directory) - depth_at(4.5)(directory)
    change = lambda directory: per_cent(rate_at(4.5)(directory), rate_at(1.5)(directory))
    return [
        *(q(f"depth.at_{time:g}", f"depth of material at {time:g} s", "cm", f"{paper:g}", BIN, time, depth_at(time))
          for time, paper in DEPTH_TIMES.items()),
        q("depth.fall", "fall of the surface between them", "cm", "31.1", BIN, 4.5, fall),
        q("depth.rate", "change of the rate between them", "%", "roughly independent", BIN, 4.5, change, ".2f", False),
        q("critical_state.rate", "rate of critical state against relaxed", "%", "virtually indistinguishable",
          ("bin", "bin_critical_state"), 4.5, rates_apart(STEADY), ".2f", False),
        q("critical_state.nu", "greatest difference of ν on the centreline", "", "virtually indistinguishable",
          ("bin", "bin_critical_state"), 4.5, profiles_apart(STEADY), ".4f", False),
        q("critical_state.bubble", "area of the bubble against relaxed", "%", "very similar",
          ("bubble_relaxed", "bubble_critical_state"), 0.5, area, ".1f"),
        q("gas.rate", "1 mm: rate with air against without, 1 to 2 s", "%", "essentially the same", ("bin", "bin_air"),
          2.0, rates_apart(PLATEAU), ".2f", False),
        q("gas.nu", "greatest difference of ν on the centreline", "", "overlaps almost exactly", ("bin", "bin_air"),
          2.0, profiles_apart(PLATEAU), ".4f", False),
        q("fine.rate", "100 µm without air against 1 mm", "%", "almost the same", ("bin", "fine_vacuum"), 1.2,
          rates_apart(FINE)),
        q("flutter.relaxed", "v_y alternating from cell to cell in the plug, over its mean, relaxed", "", "none", BIN, 1.0,
          flutter.short_waves, ".1e", False),
        q("flutter.instantaneous", "the same, instantaneous", "", "persistent", ("bin_instantaneous",), 1.0,
          flutter.short_waves, ".1e", False),
        *(q(f"friction.{model}", f"height over width of the bubble, {model.replace('_', ' ')}", "", paper, (name,), 0.5,
            elongation, ".2f") for (model, name), paper in zip(BUBBLES.items(), ("", "", "more elongated"))),
    ]


def of_findings():
    q = Quantity
    both = ("bin", "bin_equilibrium")
    return [
        q("starts.uniform", "plateau rate from the uniform start, 1 to 2 s", "g/s", "", BIN, 2.0, rate(PLATEAU)),
        q("starts.equilibrium", "from equilibrium", "g/s", "", ("bin_equilibrium",), 2.0, rate(PLATEAU)),
        q("starts.apart", "difference", "%", "", both, 2.0, rates_apart(PLATEAU), ".2f", False),
        q("starts.swing_uniform", "swing of the rate from 0.2 to 1 s, uniform", "g/s", "", BIN, 1.0, start_swing,
          ".2f", False),
        q("starts.swing_equilibrium", "from equilibrium", "g/s", "", ("bin_equilibrium",), 1.0, start_swing, ".2f",
          False),
        q("starts.same_from", "rates within 1 % from", "s", "", both, 2.0, starts_agree, ".2f", False),
        *(q(f"parameters.{parameter.option}{suffix}", f"d ln W/d ln {parameter.symbol}{note}, coarse grid", "", "",
            parameter_runs(parameter), 0.7, derivative(parameter, what), "+.3f" if not what else ".3f", False)
          for parameter in paper_runs.PARAMETERS
          for what, suffix, note in ((0, "", ""), (1, "_uncertainty", ", uncertainty"))),
    ]


def of_convergence():
    q = Quantity
    return [
        *(q(f"convergence.rate_at_{time:g}", f"rate at {time:g} s", "g/s", "", BIN, time, rate_at(time))
          for time in (0.05, 0.085, 0.1)),
        q("convergence.rate_early", "mean rate, 0.3 to 0.5 s", "g/s", "", BIN, 0.5, rate(EARLY)),
        q("convergence.nu_early", "ν in the orifice plane, 0.3 to 0.5 s", "", "0.52", BIN, 0.5, in_plane(NU, EARLY),
          ".4f"),
        q("convergence.chi_early", "χ there", "", "about 0.9", BIN, 0.5, in_plane(CHI, EARLY), ".4f"),
        q("convergence.rate", "mean rate, 1.5 to 4.5 s", "g/s", "about 144", BIN, 4.5, rate(STEADY)),
        q("convergence.nu", "ν in the orifice plane, 1.5 to 4.5 s", "", "0.52", BIN, 4.5, in_plane(NU, STEADY), ".4f"),
        q("convergence.chi", "χ there", "", "about 0.9", BIN, 4.5, in_plane(CHI, STEADY), ".4f"),
        *(q(f"convergence.{model}_{end}", f"bubble, {model.replace('_', ' ')}: {end}", unit.replace("2", "²"), "",
            (name,), 0.5,
            lambda directory, end=end: bubble(directory)[end], ".2f")
          for model, name in BUBBLES.items() for end, unit in BUBBLE_ENDS.items()),
    ]


#: Section of the page -> quantities.
SECTIONS = {"figures": of_figures(), "claims": of_claims(), "findings": of_findings(), "convergence": of_convergence()}


# ---- values ----


class Values:
    """Values of quantities on grids, kept in OUT/values.json while their runs and the scripts are what they were."""

    def __init__(self, runs, out):
        self.runs, self.file = runs, Path(out) / "values.json"
        here = Path(__file__).parent
        self.scripts = max(os.path.getmtime(path) for path in (*here.glob("*.py"), *here.parent.glob("*.py")))
        self.kept = json.loads(self.file.read_text()) if self.file.exists() else {}

    def directories(self, quantity, grid):
        """Of the runs, or None where one is missing or too short."""
        entries = [TABLE[name] for name in quantity.runs]
        if any(self.runs.record(entry, grid)["reached"] < quantity.until * (1 - 1e-9) for entry in entries):
            return None
        found = [self.runs.find(entry, grid) for entry in entries]
        return found if all(found) else None

    def value(self, quantity, grid):
        """The number, or None where the runs do not give it."""
        directories = self.directories(quantity, grid)
        if not directories:
            return None
        stamp = [self.scripts, *(os.path.getmtime(directory.parent / "run.json") for directory in directories)]
        name = f"{quantity.key} {grid}"
        if self.kept.get(name, {}).get("of") != stamp:
            self.kept[name] = {"of": stamp, "value": float(quantity.read(*directories))}
        return self.kept[name]["value"]

    def on_grids(self, quantity):
        """grid -> value, as far as there are any."""
        found = {grid: self.value(quantity, grid) for grid in GRIDS}
        return {grid: value for grid, value in found.items() if value is not None and math.isfinite(value)}

    def cell_size(self, quantity, grid):
        """Root of the mean cell area [cm]."""
        fields = output.last_fields(self.directories(quantity, grid)[0])
        x, y = fields["x_faces"], fields["y_faces"]
        return 100 * math.sqrt((x[-1] - x[0]) * (y[-1] - y[0]) / ((len(x) - 1) * (len(y) - 1)))

    def cpu(self, quantity, grid):
        """CPU seconds of its runs."""
        return sum(self.runs.cost(TABLE[name], grid)["cpu"] for name in quantity.runs)

    def limit(self, quantity):
        """The value extrapolated to fine cells, or None where there are fewer than two grids."""
        values = self.on_grids(quantity)
        finest = [grid for grid in reversed(GRIDS) if grid in values][:3]
        if len(finest) < 2 or not quantity.grids:
            return None
        sizes = [self.cell_size(quantity, grid) for grid in finest]
        columns = [np.array([values[grid]]) for grid in finest]
        value, order, regular = Series("upwind", sizes, columns).limit()
        correction = abs(value[0] - values[finest[0]])
        # As work_precision.grid_reference: part of the correction, all of it where the order is not seen.
        doubt = correction * (CORRECTION_DOUBT if regular else 1)
        if regular and order in ORDER_RANGE:  # what the grids show lies beyond: they are not fine enough to go by it
            doubt = max(doubt, abs(value[0] - extrapolated(sizes, columns, 1.0)[0]))
        return Limit(float(value[0]), float(doubt), order, regular, len(finest))

    def keep(self):
        self.file.parent.mkdir(parents=True, exist_ok=True)
        new = self.file.with_suffix(".new")
        new.write_text(json.dumps(self.kept, indent=0))
        new.rename(self.file)


@dataclass(frozen=True)
class Limit:
    """An extrapolated value, what it is uncertain by, the order; regular: seen on three grids, not assumed."""

    value: float
    doubt: float
    order: float
    regular: bool
    grids: int

    @property
    def how(self):
        if self.regular:
            return f"order {self.order:.2f}"
        return "irregular, order 1 assumed" if self.grids > 2 else "order 1 assumed"
