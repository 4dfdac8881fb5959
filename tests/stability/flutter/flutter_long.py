"""H8 in the bin: the plug at .3 s, as it dilates, goes on for 8 ms with friction coupled and lagged. Writes bin.csv,
the data of the plot, anew with --update. Half a minute."""
import csv

import numpy as np
from scree_program import Checks, Program, output
from waves import divergence, lagged_factor, rows, roughness

CASE, START, END, STEP = "../../../cases/bin_discharge/coarse.yaml", 0.3, 0.308, 1e-4
PLUG = 0.1, 0.4  # heights [m]; the floor is at .05
FIXED = {"time_step_adaptive": "no", "time_step_initial": STEP, "output_interval": STEP, "end_time": END}
LAGGED = {**FIXED, "friction_lagged": "yes"}
INSTANTANEOUS = {"friction_model": "instantaneous"}
COLUMNS = ("time", "div_across", "div_along", "nu_across", "nu_along", "dilation")


def history(run):
    """Rows of COLUMNS after the restart."""
    lines = []
    for fields in map(output.fields, output.field_files(run.directory)):
        plug = rows(fields, *PLUG)
        div, nu = divergence(fields)[plug], fields["solids_fraction"][plug]
        lines.append((fields["time"] - START, roughness(div[:, 4:], 1), roughness(div, 0), roughness(nu[:, 4:], 1),
                      roughness(nu, 0), div.mean()))
    return np.array(lines)


def factor(lines):
    """Per step, from five times the smooth state's up to a tenth of the dilation, where the first cells compact."""
    rough = lines[:, 1]
    first = np.argmax(rough > 5 * rough[0])
    last = np.argmax(rough > 0.1 * lines[:, 5])
    return (rough[last] / rough[first]) ** (1 / (last - first))


program, checks = Program(), Checks("flutter in the bin", "H8")
start = {model: program.run(CASE, f"start_{model}", {"friction_model": model, "end_time": START})
         for model in ("relaxed", "instantaneous")}
runs, histories, amplitudes = {}, {}, {}
for name, model, options in (
        ("instantaneous, coupled", "instantaneous", FIXED),
        ("relaxed, coupled", "relaxed", FIXED),
        ("relaxed, lagged", "relaxed", LAGGED),
        ("instantaneous, lagged", "relaxed", {**LAGGED, **INSTANTANEOUS}),
        ("instantaneous, lagged, van_albada", "relaxed", {**LAGGED, **INSTANTANEOUS, "advection": "van_albada"})):
    options = {"restart": start[model].directory, **options}
    runs[name] = program.run(None, name.replace(", ", "_"), options, timeout=3600)
    histories[name] = lines = history(runs[name])
    amplitudes[name] = (lines[:, 1] / lines[:, 5])[-20:].max()
    if name.startswith("instantaneous, lagged"):
        checks.above(f"{name}: short waves of div v, over the dilation", amplitudes[name], 0.5)
    else:
        checks.below(f"{name}: short waves of div v, over the dilation", amplitudes[name], 0.01)

fields = start["relaxed"].fields
plug = rows(fields, *PLUG)
cells = np.diff(fields["x_faces"])[-1], np.diff(fields["y_faces"])[-1]
nu, T = fields["solids_fraction"][plug].mean(), np.median(fields["granular_temperature"][plug])
linear, measured = lagged_factor(nu, T, cells, 0, STEP), factor(histories["instantaneous, lagged"])
checks.close("instantaneous, lagged: factor per step", measured, linear, relative=0.05)
outflow = {name: run.monitor["flux_orifice"][run.monitor["time"] > START].mean() for name, run in runs.items()}
checks.below("instantaneous, lagged: change of the flow through the orifice",
             abs(outflow["instantaneous, lagged"] / outflow["relaxed, coupled"] - 1), 5e-3)
checks.hard_case("H8", "plug of the bin, friction coupled", runs["instantaneous, coupled"],
                 measured=f"lagged, short waves grow by {measured:.2f} a step (linear theory {linear:.2f}) up to "
                          f"{amplitudes['instantaneous, lagged']:.1f} times the dilation",
                 bound="no short waves with friction coupled or relaxed")
if program.update:
    with open(program.here / "bin.csv", "w", newline="") as file:
        writer = csv.writer(file)
        writer.writerow(("run", *COLUMNS))
        for name, lines in histories.items():
            writer.writerows((name, *(f"{value:.4g}" for value in line)) for line in lines)
checks.verdict()
