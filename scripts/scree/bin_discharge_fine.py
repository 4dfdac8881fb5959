"""Draws the discharge of fine particles and prints the numbers to compare with the paper (Figs 10 to 12).

Into OUT_DIR/plots: discharge_rate.png and centreline.png (nu, and p_g of the runs with air), all runs, in the first
OUT_DIR; bottom_map.png (each run). Give the run with air and the one without together.
"""

import matplotlib.pyplot as plt
import numpy as np

from scree import bin_discharge, output, plots


class Run(bin_discharge.Run):
    """With the profiles along the centreline averaged over the fields from `since` on."""

    def __init__(self, directory, since):
        super().__init__(directory)
        profiles = {"solids_fraction": [], "gas_pressure": []}
        self.since = min(since, 0.6 * self.time)
        for path in output.files_between(directory, self.since, np.inf):
            fields = output.fields(path, profiles)
            for name, means in profiles.items():
                if name in fields:
                    means.append(self.centreline(fields[name]))
        self.nu_profile = np.mean(profiles["solids_fraction"], axis=0)
        self.p_g_profile = np.mean(profiles["gas_pressure"], axis=0) if profiles["gas_pressure"] else None

    def late_rate(self):
        """Mean rate from `since` on [g/s]."""
        return self.mean_rate((self.since, self.monitor_time[-1]))


def draw_discharge_rate(runs):
    figure, axes = plt.subplots(figsize=(6.4, 4.2))
    for run in runs:
        axes.plot(run.monitor_time, run.rate, label=run.label)
    axes.set(xlabel="time (s)", ylabel="discharge rate (g/s)", xlim=(0, max(r.monitor_time[-1] for r in runs)))
    axes.set_ylim(0, 1.1 * max(np.nanmax(run.rate) for run in runs))
    axes.legend(loc="lower right")
    return figure


def draw_centreline(runs):
    figure, (fractions, pressures) = plt.subplots(2, 1, sharex=True, figsize=(6.4, 6.4))
    for run in runs:
        (line,) = fractions.plot(run.y, run.nu_profile, label=f"{run.label}, mean from {run.since:.2g} s")
        if run.p_g_profile is not None:
            pressures.plot(run.y, run.p_g_profile, color=line.get_color())
    fractions.set(ylabel=r"solids fraction $\nu$ (–)", ylim=(0, 0.68))
    fractions.legend(loc="lower right")
    pressures.set(ylabel=r"gas pressure $p_g$ (Pa)", xlabel="height above the orifice plane (cm)")
    pressures.set_xlim(-bin_discharge.BELOW, bin_discharge.ABOVE)
    for axes in (fractions, pressures):
        axes.axvline(0, color="0.6", linewidth=1, zorder=0)
    return figure


def report(run):
    print(f"{run.directory}: orifice {2 * run.orifice:.3g} cm, means from {run.since:.2g} to {run.monitor_time[-1]:.3g} s")
    print(f"  rate                                   {run.late_rate():8.1f} g/s")
    for time in (0.1, 0.3, 0.5, 1.0):
        if run.monitor_time[-1] >= time - 1e-9:
            print(f"  rate at {time:3.1f} s                          {np.interp(time, run.monitor_time, run.rate):8.1f} g/s")
    in_plane = lambda profile: np.interp(0.0, run.y, profile)
    at_10 = np.interp(10.0, run.y, run.nu_profile)
    print(f"  nu on the axis in the orifice plane    {in_plane(run.nu_profile):8.3f}, 10 cm above it {at_10:.3f}")
    if run.p_g_profile is not None:
        lowest = np.argmin(run.p_g_profile)
        print(f"  lowest p_g on the axis                 {run.p_g_profile[lowest]:8.0f} Pa at {run.y[lowest]:.1f} cm")
        print(f"  p_g on the axis in the orifice plane   {in_plane(run.p_g_profile):8.0f} Pa")


def main():
    since = ("--since", dict(type=float, default=0.6, help="start of the means [s]; default 0.6"))
    arguments = plots.arguments(__doc__, since)
    runs = [Run(directory, arguments.since) for directory in arguments.directories]
    plots.save(draw_discharge_rate(runs), runs[0].directory, "discharge_rate.png")
    plots.save(draw_centreline(runs), runs[0].directory, "centreline.png")
    for run in runs:
        plots.save(bin_discharge.draw_bottom_map(run), run.directory, "bottom_map.png")
        report(run)

