"""A finished run: its fields as xarray, its monitor as pandas, its case and summary, and plots of them."""
import re
from functools import cached_property
from pathlib import Path

import pandas
import xarray

from scree import output

AXES = "xyz"


def open(directory):  # noqa: A001  (scree.open, as in xarray.open_dataset)
    """What a run left in a directory, as a Run. Raises FileNotFoundError where there is none."""
    return Run(directory)


class Run:
    """What a run left in its output directory. All numbers are SI; units stand in `attrs`."""

    def __init__(self, directory):
        """Raises FileNotFoundError where the directory holds no run."""
        self.directory = Path(directory)
        if not (self.directory / "monitor.csv").exists():
            raise FileNotFoundError(f"{directory} holds no run: it has no monitor.csv")

    def __repr__(self):
        times = self.times
        until = f", {len(times)} fields up to {times[-1]:.4g} s" if len(times) else ""
        return f"<scree.Run {self.directory}{until}>"

    @cached_property
    def summary(self):
        """summary.json as a dict: how the run ended, its quantities, what it took. Empty where the run has not ended."""
        try:
            return output.summary(self.directory)
        except FileNotFoundError:
            return {}

    @cached_property
    def case(self):
        """The effective case: option -> text, SI."""
        return output.case(self.directory)

    @cached_property
    def log(self):
        """What the program said, or None where that was not kept."""
        for file in (self.directory / "log", self.directory / "log.part"):  # of a run that is under way or was killed
            if file.exists():
                return file.read_text(errors="replace")
        return None

    @cached_property
    def monitor(self):
        """monitor.csv as a pandas.DataFrame, a row a step; attrs["units"]: column -> unit."""
        table = pandas.DataFrame(output.monitor(self.directory))
        table.attrs["units"] = {name: output.unit_of(name, self.units) for name in table}
        return table

    @cached_property
    def units(self):
        """Units of the fields and of the components of vectors, such as velocity_x: name -> SI unit."""
        units = {name: entry["unit"] for name, entry in self.attributes.items() if "unit" in entry}
        return {**units, **{name.removesuffix("_face"): unit for name, unit in units.items()}}

    # ---- fields ----

    @cached_property
    def _files(self):
        return output.field_files(self.directory)

    @cached_property
    def attributes(self):
        """What the field files say of their datasets: name -> {unit, text, symbol}."""
        return output.attributes(self._files[0]) if self._files else {}

    @cached_property
    def times(self):
        """Times of the fields [s]."""
        return [output.time_of_file(path) for path in self._files]

    @cached_property
    def fields(self):
        """All fields at all times, see dataset(), which takes parts of them where they are large."""
        return self.dataset()

    def dataset(self, names=None, times=None):
        """Fields as an xarray.Dataset with dimensions (time, [z,] y, x), coordinates at the cell centres [m].

        Vectors such as velocity are at cell centres, with the dimension `component`; velocity_x_face and its like are
        the values that the program solves for, with the coordinate x_face along their axis. names: fields to read, all
        without. times: those nearest to these times [s], all without. Raises KeyError with the names that there are."""
        if not self._files:
            raise FileNotFoundError(f"no field files in {self.directory}/fields")
        self._check_names(names)
        files = self._files if times is None else self._nearest(times)
        return xarray.concat([self._read(path, names) for path in files], "time")

    def at(self, time, names=None):
        """The fields nearest to a time [s], without the dimension time; None: the last."""
        return self.dataset(names, [self.times[-1] if time is None else time]).isel(time=0)

    def _check_names(self, names):
        for name in names or ():
            if name not in self.attributes:
                known = [known for known in self.attributes if not known.endswith("_faces")]
                raise KeyError(f"no field {name} in {self.directory}: there are {', '.join(known)}")

    def _nearest(self, times):
        wanted = {min(range(len(self.times)), key=lambda k: abs(self.times[k] - time)) for time in times}
        return [self._files[k] for k in sorted(wanted)]

    def _read(self, path, names):
        raw = output.fields(path, None if names is None else [*names, "x_faces", "y_faces", "z_faces"])
        time = raw.pop("time")
        faces = {axis: raw.pop(f"{axis}_faces") for axis in AXES if f"{axis}_faces" in raw}
        coordinates = {"time": [time], "component": list(AXES)}
        for axis, places in faces.items():
            coordinates[axis] = (axis, output.centres(places), {"units": "m"})
            coordinates[f"{axis}_face"] = (f"{axis}_face", places, {"units": "m"})
        variables = {name: (("time", *self._dimensions(name, values, faces)), values[None], self._describe(name))
                     for name, values in raw.items()}
        used = {dimension for dimensions, *_ in variables.values() for dimension in dimensions}
        result = xarray.Dataset(variables, {name: value for name, value in coordinates.items()
                                            if name in used or name.endswith("_face")})
        result.time.attrs["units"] = "s"
        return result

    def _describe(self, name):
        entry = self.attributes[name]
        return {"units": entry.get("unit", ""), "long_name": entry.get("text", name), "symbol": entry.get("symbol", "")}

    @staticmethod
    def _dimensions(name, values, faces):
        """The dimensions of a dataset: slowest axis first; vectors have their components last."""
        at_face = re.search(r"_([xyz])_face$", name)
        axes = [f"{axis}_face" if at_face and at_face[1] == axis else axis for axis in reversed(faces)]
        return axes if values.ndim == len(axes) else [*axes, "component"]

    # ---- sampled lines ----

    @cached_property
    def lines(self):
        """Sampled lines of the case: name -> pandas.DataFrame with time, place [m] and the fields of all times."""
        parts = {}
        for path in sorted((self.directory / "lines").glob("*_*.csv")):
            parts.setdefault(re.sub(r"_\d+$", "", path.stem), []).append(pandas.read_csv(path))
        return {name: pandas.concat(tables, ignore_index=True) for name, tables in parts.items()}

    # ---- plots ----

    def plot(self, field, time=None, axes=None, arrows=None):
        """A map of a field, in one dimension a curve, at the output time nearest to `time` [s], the last without.

        field: a name of `fields`; of a vector its size. arrows: a vector to draw on it, such as "velocity". axes: of
        matplotlib, to draw into. Returns the figure."""
        from scree import plots

        return plots.draw_field(self, field, time, axes, arrows)

    def plot_monitor(self, columns, axes=None):
        """Columns of the monitor against time; a name or several of one unit. Returns the figure."""
        from scree import plots

        return plots.draw_monitor(self, [columns] if isinstance(columns, str) else columns, axes)
