"""Tables of what runs cost and how far they are off: runs.csv, and the cheapest setting for an accuracy."""
import csv
import dataclasses
import math
from dataclasses import dataclass

from scree.work_precision import Row, Setting, model_variants, quantities, size

TARGETS = (0.10, 0.03, 0.01, 0.003)  # relative errors
COST_NAMES = ("steps", "newton", "krylov", "cpu_s", "cpu_residual_s", "cpu_jacobian_s", "cpu_setup_s", "cpu_krylov_s",
              "wall_s", "memory_per_rank_MB", "cpu_s_first_0.1_s", "cpu_s_per_s_late")


def write_csv(path, case, rows, units, usual):
    """A row a run: setting, cost, quantities (profiles by their root mean square) and their errors, in per cent of the
    reference. units: quantity -> unit."""
    names = quantities(rows)
    head = ["case", "label", *(f.name for f in dataclasses.fields(Setting)), "cell_size_cm", *COST_NAMES]
    head += [f"{name} [{units.get(name, '-')}]" for name in names]
    for name in names:
        head += [f"error_total {name} [%]", f"uncertainty {name} [%]", f"error_time {name} [%]",
                 f"uncertainty_time {name} [%]", f"error_model {name} [%]"]
    with open(path, "w", newline="") as file:
        writer = csv.writer(file)
        writer.writerow(head)
        for row in rows:
            values = {**dataclasses.asdict(row.setting), "solver": row.setting.preset}
            cells = [case, row.setting.label(usual), *values.values(), number(row.cell_size)]
            cells += [number(row.cost.get(name, math.nan)) for name in COST_NAMES]
            cells += [number(size(row.values[name])) for name in names]
            for name in names:
                found = (row.error("total", name), row.doubt("total", name), row.error("time", name),
                         row.doubt("time", name), row.error("model", name))
                cells += [number(100 * value) for value in found]
            writer.writerow(cells)


def number(value):
    return f"{value:.5g}" if math.isfinite(value) else ""


@dataclass
class Choice:
    """The cheapest run within `target`, or the one nearest to it."""

    target: float
    row: Row
    error: float
    doubt: float

    @property
    def reached(self):
        return self.error <= self.target

    @property
    def certain(self):
        return self.error + self.doubt <= self.target


def worst(row, names, kind="total"):
    """The greatest error of the quantities, and the uncertainty that it has; infinite where one is missing."""
    pairs = [(row.error(kind, name), row.doubt(kind, name)) for name in names]
    return max(pairs) if pairs and all(math.isfinite(error) for error, _ in pairs) else (math.inf, math.nan)


def choices(rows, names, targets=TARGETS):
    """For each target the cheapest run whose greatest error of the quantities `names` is within it."""
    judged = [(*worst(row, names), row) for row in rows]
    judged = [(error, doubt, row) for error, doubt, row in judged if math.isfinite(error)]
    result = []
    for target in targets if judged else []:
        within = [item for item in judged if item[0] <= target]
        error, doubt, row = (min(within, key=lambda item: item[2].cost["cpu_s"]) if within
                             else min(judged, key=lambda item: (item[0], item[2].cost["cpu_s"])))
        result.append(Choice(target, row, error, doubt))
    return result


def choice_text(case, rows, references, usual):
    """The page choice.md."""
    names = quantities(rows)
    lines = [f"# {case}: which setting for which error", "",
             "CPU seconds of all ranks. Errors are relative, against values extrapolated over the grids: "
             "`~` marks an error that its uncertainty leaves open, `>` that none is within the target: the nearest.", ""]
    heads = [f"{100 * target:g} %" for target in TARGETS]
    lines += ["| quantity | " + " | ".join(heads) + " |", "|---|" + "---|" * len(heads)]
    for title, group in [(name, [name]) for name in names] + [("all of them", names)]:
        found = [choice_cell(choice, usual) for choice in choices(rows, group)] or ["-"] * len(heads)
        lines.append(f"| {title} | " + " | ".join(found) + " |")
    lines += ["", "## What errors are measured against", ""]
    for name, reference in references.items():
        lines.append(f"- {name}: " + (f"{size(reference.value):.4g} ± {100 * reference.doubt:.2g} %, {reference.how}"
                                      if reference else "no reference: fewer than two grids"))
    lines += ["", "## Simpler models, against the full one on the same grid", ""]
    variants = model_variants(rows)
    for row, full in variants:
        errors = ", ".join(f"{name} {100 * row.error('model', name):.2g} %" for name in names
                           if math.isfinite(row.error("model", name)))
        lines.append(f"- {model_name(row.setting)}, {row.setting.grid}: {row.cost['cpu_s'] / full.cost['cpu_s']:.2f} "
                     f"of the cost of {model_name(full.setting)}; off by {errors}")
    return "\n".join(lines + ([] if variants else ["None were run."])) + "\n"


def choice_cell(choice, usual):
    mark = "" if choice.certain else "~ " if choice.reached else "> "
    return (f"{mark}{choice.row.setting.label(usual)}: {choice.row.cost['cpu_s']:.3g} s, "
            f"{100 * choice.error:.2g} ± {100 * choice.doubt:.2g} %")


def model_name(setting):
    """The model in a few words."""
    gas = {"none": "no gas", "darcy": "darcy gas", "incompressible": "gas with inertia"}[setting.gas]
    temperature = {"transport": "", "algebraic": ", algebraic T", "constant": ", constant T"}[setting.granular_temperature]
    return f"{setting.friction_model}{temperature}, {gas}, {setting.width} width"
