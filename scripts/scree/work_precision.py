"""What a run costs and how far it is off: orders and extrapolation over grids, errors of grid, time step and model.
Numbers only; work_precision_tables.py and work_precision_plots.py show them."""
import dataclasses
import math
from dataclasses import dataclass, field

import numpy as np

#: Orders outside of this are not believed: below, the extrapolation runs away; above, no scheme here can do it.
ORDER_RANGE = (0.5, 2.0)
#: Part of its own correction that an extrapolated value is taken to be wrong by at least (Roache's factor is 1.25).
CORRECTION_DOUBT = 0.25
#: Among runs of the same accuracy the one whose time scheme stands first here is the reference of the others.
SCHEMES_BY_ORDER = ("arkimex", "bdf", "beuler")


@dataclass(frozen=True)
class Setting:
    """What distinguishes the runs of a case. solver "" is the program's default."""

    grid: str
    advection: str = "upwind"
    time_scheme: str = "beuler"
    accuracy: float = 0.1
    friction_model: str = "relaxed"
    granular_temperature: str = "transport"
    gas: str = "none"
    width: str = "half"
    solver: str = ""
    ranks: int = 1

    @property
    def preset(self):
        return self.solver or "default"

    @property
    def model(self):
        return self.friction_model, self.granular_temperature, self.gas, self.width

    def but(self, **changes):
        return dataclasses.replace(self, **changes)

    def label(self, usual):
        """Short and fit for a directory: grid, schemes, accuracy, and in what else it differs from `usual`."""
        parts = [self.grid.replace(" ", ""), self.advection, self.time_scheme, f"{self.accuracy:.0e}"]
        parts += [value for value, default in zip(self.model[:2], usual.model[:2]) if value != default]
        parts += [f"gas-{self.gas}"] if self.gas != usual.gas else []
        parts += [f"{self.width}-width"] if self.width != usual.width else []
        parts += [self.solver] if self.solver else []
        parts += [f"{self.ranks}ranks"] if self.ranks > 1 else []
        return "_".join(parts)


@dataclass
class Row:
    """A run. cost: name -> number; values: quantity -> array, of one number or along a line (NaN where the model has
    none). errors: kind ("total", "time", "model") -> quantity -> relative error; doubts likewise: what it is uncertain
    by."""

    setting: Setting
    cell_size: float  # root of the area of the smallest cell [cm]
    cost: dict
    values: dict
    family: str = "uniform"  # grids that refine one another
    errors: dict = field(default_factory=lambda: {"total": {}, "time": {}, "model": {}})
    doubts: dict = field(default_factory=lambda: {"total": {}, "time": {}})

    def error(self, kind, quantity):
        return self.errors[kind].get(quantity, math.nan)

    def doubt(self, kind, quantity):
        return self.doubts[kind].get(quantity, math.nan)


@dataclass
class Reference:
    """What the errors of grid are measured against: value, its relative uncertainty, and where it comes from."""

    value: np.ndarray
    doubt: float
    order: float
    how: str


# ---- extrapolation over grids ----


def size(values):
    """Root of the mean square."""
    return float(np.sqrt(np.mean(np.square(values))))


def difference_ratio(order, sizes):
    """(f3 - f2)/(f2 - f1) of an error that goes with cell size to `order`; sizes from fine to coarse."""
    fine, middle, coarse = (h**order for h in sizes)
    return (coarse - middle) / (middle - fine)


def observed_order(sizes, values):
    """The order that three grids show, clipped to ORDER_RANGE, and whether it is regular: the differences have one
    direction and shrink. Cell sizes from fine to coarse; values may be profiles."""
    first, second = values[1] - values[0], values[2] - values[1]
    if size(first) == 0:
        return ORDER_RANGE[1], True
    ratio = size(second) / size(first)
    # An error of order 0, the logarithm of h, is what differences that only just shrink would look like.
    no_order = math.log(sizes[2] / sizes[1]) / math.log(sizes[1] / sizes[0])
    if np.mean(first * second) <= 0 or ratio <= no_order:
        return 1.0, False
    low, high = ORDER_RANGE
    if ratio <= difference_ratio(low, sizes):
        return low, True
    if ratio >= difference_ratio(high, sizes):
        return high, True
    for _ in range(60):  # the ratio grows with the order
        middle = (low + high) / 2
        low, high = (middle, high) if difference_ratio(middle, sizes) < ratio else (low, middle)
    return (low + high) / 2, True


def extrapolated(sizes, values, order):
    """Richardson's value at cell size 0 from the two finest grids."""
    return values[0] + (values[0] - values[1]) / ((sizes[1] / sizes[0]) ** order - 1)


@dataclass
class Series:
    """Runs of one advection scheme over grids, from fine to coarse."""

    advection: str
    sizes: list
    values: list

    def limit(self):
        """Extrapolated value, order, whether that is regular."""
        order, regular = observed_order(self.sizes, self.values) if len(self.sizes) > 2 else (1.0, False)
        return extrapolated(self.sizes, self.values, order), order, regular


def plain(rows, usual):
    """Runs that differ from the default in grid, advection, time only, and with its time scheme."""
    same = ("time_scheme", "friction_model", "granular_temperature", "gas", "width", "solver", "ranks")
    return [row for row in rows
            if all(getattr(row.setting, name) == getattr(usual, name) for name in same)]


def families(rows):
    """Lists of the rows of each family of two grids or more, each with other factors of its errors, the one with the
    smallest cells first. One of two grids, which shows no order, stands back behind those of three."""
    groups = {}
    for row in rows:
        groups.setdefault(row.family, []).append(row)
    grids = {name: len({row.setting.grid for row in group}) for name, group in groups.items()}
    several = [name for name, count in grids.items() if count > 1]
    several.sort(key=lambda name: (-min(grids[name], 3), min(row.cell_size for row in groups[name])))
    return [groups[name] for name in several]


def reference_accuracy(rows):
    """The accuracy at which some scheme has the finest three grids; among equals the tightest."""
    best = None
    for accuracy in sorted({row.setting.accuracy for row in rows}):
        for advection in {row.setting.advection for row in rows}:
            found = sorted(row.cell_size for row in rows if row.setting.accuracy == accuracy
                           and row.setting.advection == advection)[:3]
            if len(found) > 1:
                key = (len(found) < 3, *found)
                best = min(best, (key, accuracy)) if best else (key, accuracy)
    return best[1] if best else None


def grid_series(rows, quantity, accuracy):
    """The series of each advection scheme with two grids or more, at one accuracy."""
    result = []
    for advection in sorted({row.setting.advection for row in rows}):
        chosen = sorted((row for row in rows if row.setting.advection == advection and row.setting.accuracy == accuracy
                         and np.all(np.isfinite(row.values[quantity]))), key=lambda row: row.cell_size)[:3]
        if len(chosen) > 1:
            result.append(Series(advection, [row.cell_size for row in chosen], [row.values[quantity] for row in chosen]))
    return result


def grid_reference(rows, quantity, usual):
    """The value without error of grid, or None where there are fewer than two grids: that of the family of grids with the
    smallest cells. Another family of three grids that contradicts it, farther off than both are uncertain by, is as
    likely: then the mean of both, uncertain by half their distance more. Not so one whose cells are all larger: how far
    its orders hold is not known below them."""
    rows = plain(rows, usual)
    groups = families(rows)
    found = [family_reference(group, quantity, rows) for group in groups]
    best = found[0] if found else None
    for other, group in zip(found[1:], groups[1:]):
        finest = min(row.cell_size for row in group)
        reaches = finest <= max(row.cell_size for row in groups[0]) and len({row.setting.grid for row in group}) > 2
        if best and other and reaches and contradicts(best, other):
            best = mean_of(best, other)
    return best


def absolute_doubt(reference):
    return reference.doubt * size(reference.value)


def contradicts(one, other):
    return size(one.value - other.value) > absolute_doubt(one) + absolute_doubt(other)


def mean_of(one, other):
    value = (one.value + other.value) / 2
    doubt = size(one.value - other.value) / 2 + max(absolute_doubt(one), absolute_doubt(other))
    return Reference(value, doubt / size(value), one.order, f"mean of two families of grids: {one.how}, and {other.how}")


def family_reference(rows, quantity, all_rows):
    """The value without error of grid that a family of grids leads to.

    Richardson's extrapolation of the advection scheme that it moves least; if its order is irregular the mean of the
    schemes' extrapolations. Uncertain by half the distance of the schemes' extrapolations, at least CORRECTION_DOUBT of
    the correction, where the order was clipped at least the distance to order 1, plus what the steps in time make,
    seen on any family."""
    accuracy = reference_accuracy(rows)
    series = grid_series(rows, quantity, accuracy) if accuracy else []
    if not series:
        return None
    finest = min(one.sizes[0] for one in series)
    limits = [(*one.limit(), one) for one in series]
    # A scheme that was run on coarser grids only cannot be the better one.
    correction, best = min(((size(limit[0] - limit[3].values[0]), limit) for limit in limits if limit[3].sizes[0] == finest),
                           key=lambda pair: pair[0])
    value, order, regular, one = best
    spread = max(size(limit[0] - value) for limit in limits) / 2
    irregular = "orders irregular" if len(one.sizes) > 2 else "two grids only, order 1 assumed"
    if regular:
        clipped = size(extrapolated(one.sizes, one.values, 1.0) - value) if order in ORDER_RANGE else 0.0
        doubt, how = max(spread, CORRECTION_DOUBT * correction, clipped), f"{one.advection}, order {order:.2f}"
    elif len(limits) > 1:
        value = np.mean([limit[0] for limit in limits], axis=0)
        doubt, how = max(spread, CORRECTION_DOUBT * correction), f"{irregular}: mean of the schemes"
    else:
        doubt, how = correction, f"{one.advection}, {irregular}"
    doubt += time_part(all_rows, quantity, accuracy, one.advection)
    how += f"; {rows[0].family} cells down to {finest:.2g} cm, accuracy {accuracy:g}"
    return Reference(value, doubt / size(value) if size(value) else math.nan, order, how)


def time_part(rows, quantity, accuracy, advection):
    """What runs at this accuracy differ by from the tightest, on the finest grid that has both."""
    rows = [row for row in rows if row.setting.advection == advection and np.all(np.isfinite(row.values[quantity]))]
    at = {row.setting.grid: row for row in rows if row.setting.accuracy == accuracy}
    tighter = [row for row in rows if row.setting.accuracy < accuracy and row.setting.grid in at]
    if not tighter:
        return 0.0
    best = min(tighter, key=lambda row: (row.cell_size, row.setting.accuracy))
    return size(best.values[quantity] - at[best.setting.grid].values[quantity])


# ---- errors ----


def relative(value, reference):
    """Distance over size, NaN where either is missing."""
    scale = size(reference)
    return size(value - reference) / scale if scale > 0 else math.nan


def add_errors(rows, usual):
    """Fills errors and doubts of all rows; returns quantity -> Reference (or None) of the errors of grid."""
    references = {name: grid_reference(rows, name, usual) for name in quantities(rows)}
    for name, reference in references.items():
        for row in rows if reference else []:
            # Another model has another limit.
            if row.setting.model == usual.model:
                row.errors["total"][name] = relative(row.values[name], reference.value)
                row.doubts["total"][name] = reference.doubt
        add_time_errors(rows, name)
        add_model_errors(rows, name)
    return references


def quantities(rows):
    return list(dict.fromkeys(name for row in rows for name in row.values))


def add_time_errors(rows, name):
    """Errors against the tightest run of the same grid, advection and model. It is itself uncertain by its distance from
    the tightest of the other schemes, or else from the next accuracy."""
    groups = {}
    for row in rows:
        groups.setdefault((row.setting.grid, row.setting.advection, row.setting.model), []).append(row)
    for group in groups.values():
        candidates = sorted((row for row in group if not row.setting.solver and row.setting.ranks == 1),
                            key=lambda row: (row.setting.accuracy, SCHEMES_BY_ORDER.index(row.setting.time_scheme)))
        if len({row.setting.accuracy for row in candidates}) < 2:
            continue
        best = candidates[0]
        rivals = [row for row in candidates[1:] if row.setting.accuracy == best.setting.accuracy] or [
            next(row for row in candidates if row.setting.accuracy > best.setting.accuracy)]
        doubt = max(relative(row.values[name], best.values[name]) for row in rivals)
        for row in group:
            if row is not best:
                row.errors["time"][name] = relative(row.values[name], best.values[name])
                row.doubts["time"][name] = doubt


def fuller(setting, rows):
    """The run of the full model with which a simpler one is to be compared, or None: the same gas with everything else
    in full; where that is so, the gas with inertia."""
    if setting.solver or setting.ranks > 1:
        return None
    wanted = setting.but(friction_model="relaxed", granular_temperature="transport", width="half")
    if wanted == setting:
        wanted = setting.but(gas="incompressible")
    return next((row for row in rows if row.setting == wanted and wanted != setting), None)


def add_model_errors(rows, name):
    for row in rows:
        full = fuller(row.setting, rows)
        if full:
            row.errors["model"][name] = relative(row.values[name], full.values[name])


def model_variants(rows):
    """Pairs of a simpler model and the full one."""
    pairs = [(row, fuller(row.setting, rows)) for row in rows]
    return [(row, full) for row, full in pairs if full]
