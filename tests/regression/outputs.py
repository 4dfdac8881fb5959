"""What a run writes: when, and whether monitor.csv agrees with the fields of the same time."""
import shutil
import subprocess

import numpy as np
from scree_program import Checks, Program

END, INTERVAL, RHO_S, NU_MAX, DEPTH, MIRROR = 0.018, 0.004, 2900.0, 0.65, 0.01, 2
RUN = {"end_time": END, "output_interval": INTERVAL, "checkpoint_interval": 0.01, "probe_lip_point": "0.5 cm, 2 cm",
       "line_axis_from": "0, 0", "line_axis_to": "0, 9 cm"}


def cells_of(fields):
    """Volume of the cells of the whole bin [m3], and v^2 of each: the mean of its squares on the two faces, summed."""
    volume = np.outer(np.diff(fields["y_faces"]), np.diff(fields["x_faces"])) * DEPTH * MIRROR
    square = {axis: fields[f"velocity_{axis}_face"] ** 2 for axis in "xy"}
    return volume, (square["x"][:, 1:] + square["x"][:, :-1] + square["y"][1:, :] + square["y"][:-1, :]) / 2


def check_times(checks, run):
    due = [k * INTERVAL for k in range(5)] + [END]
    times, rows, dt = [fields["time"] for fields in run.all_fields()], run.monitor["time"], run.monitor["dt"]
    checks.equal("times of the fields, bit for bit", times, due)
    checks.equal("rows of monitor.csv at these times", [t for t in due if not np.any(np.abs(rows - t) <= 1e-14)], [])
    checks.equal("a row at the checkpoint's time", bool(np.any(np.abs(rows - 0.01) <= 1e-14)), True)
    lines = sorted((run.directory / "lines").glob("axis_*.csv"))
    checks.equal("times of the lines", [float(path.read_text().split("\n")[1].split(",")[0]) for path in lines],
                 [float(f"{t:.15g}") for t in due])
    # A step is halved at most to come out at a time, and 0.3 is the least that its error makes of it.
    untroubled = run.monitor["rejected_error"] + run.monitor["rejected_solver"] == 0
    checks.above("least step over the one before it", np.min(dt[2:] / dt[1:-1], where=untroubled[2:], initial=1.0), 0.15)


def check_energies(checks, name, run, has_T):
    fields, monitor = run.fields, run.monitor
    volume, v_squared = cells_of(fields)
    nu = fields["solids_fraction"]
    tolerance = {"relative": 1e-8}
    checks.close(f"{name}: kinetic energy [J]", monitor["kinetic_energy"][-1], (RHO_S * volume * nu * v_squared / 2).sum(), **tolerance)
    checks.close(f"{name}: weighted speed [m/s]", monitor["speed_max_weighted"][-1], np.sqrt((nu * v_squared).max() / NU_MAX), **tolerance)
    checks.equal(f"{name}: fluctuation energy is there", "fluctuation_energy" in monitor, has_T)
    if has_T:
        T = fields["granular_temperature"]
        checks.close(f"{name}: fluctuation energy [J]", monitor["fluctuation_energy"][-1], (1.5 * RHO_S * volume * nu * T).sum(), **tolerance)
        checks.close(f"{name}: weighted T [m2/s2]", monitor["granular_temperature_max_weighted"][-1], (nu * T).max() / NU_MAX, **tolerance)
        checks.close(f"{name}: greatest T [m2/s2]", monitor["granular_temperature_max"][-1], T.max(), **tolerance)


def check_columns(checks, run):
    """Each column of monitor.csv is explained in summary.json."""
    header = (run.directory / "monitor.csv").read_text().split("\n")[0].split(",")
    columns = run.summary["monitor_columns"]
    checks.equal("columns explained in summary.json", list(columns), header)
    checks.equal("columns without unit or text", [name for name, c in columns.items() if not c["unit"] or not c["text"]], [])
    for name in ("cpu_seconds", "cpu_residual", "cpu_jacobian", "cpu_setup", "cpu_solve"):
        checks.above(f"least {name}", run.monitor[name].min(), 0)
    parts = sum(run.monitor[name] for name in ("cpu_residual", "cpu_jacobian", "cpu_setup", "cpu_solve"))
    checks.above("cpu_seconds less its parts, least", (run.monitor["cpu_seconds"] - parts).min(), 0)


def check_moved(checks, program, run):
    """A run that was moved goes on where it is now."""
    moved = program.work / "moved"
    shutil.move(run.directory, moved)
    words = program.command(None, {"restart": moved, "end_time": END + 0.002})
    process = subprocess.run(words, stdin=subprocess.DEVNULL, capture_output=True, text=True, timeout=1200)
    checks.equal("moved: exit code", process.returncode, 0)
    checks.true("moved: nothing in the old place", not run.directory.exists(), "the old directory is back")
    run.directory = moved
    checks.close("moved: time reached", run.summary["time"], END + 0.002, absolute=1e-15)
    checks.equal("moved: times of the fields", [f["time"] for f in run.all_fields()], [k * INTERVAL for k in range(5)] + [END, END + 0.002])


def check_averages(checks, program):
    """Means by what a run tells of each of its steps, also over a restart."""
    options = {"end_time": 0.005, "output_average_from": 0.0015, "probe_a_point": "0.5 cm, 2 cm", "checkpoint_interval": 0.003}
    whole = program.run("small_bin.yaml", "average", options)
    monitor = whole.monitor
    weight = np.clip(monitor["time"] - 0.0015, 0, monitor["dt"])
    expected = (weight * monitor["mass"]).sum() / weight.sum()
    volume = cells_of(whole.fields)[0]
    checks.close("mass of the mean solids fraction [kg]", (RHO_S * volume * whole.fields["mean_solids_fraction"]).sum(), expected, relative=1e-9)
    checks.true("no means before their start", "mean_solids_fraction" not in whole.first_fields)
    shutil.copytree(whole.directory, program.work / "average_again")
    sorted((program.work / "average_again" / "checkpoints").glob("*.h5"))[-1].unlink()
    shutil.copytree(program.work / "average_again", program.work / "average_anew")
    again = program.run("small_bin.yaml", "average_again", {**options, "restart": program.work / "average_again"})
    checks.true("restart: bits of the means", all(np.array_equal(whole.fields[name], again.fields[name])
                                                  for name in whole.fields if name.startswith("mean_")))
    anew = program.run("small_bin.yaml", "average_anew", {**options, "output_average_from": 0.001, "restart": program.work / "average_anew"})
    checks.true("restart with another start: a remark", "averages begin anew" in anew.log, anew.log)
    weight = np.clip(monitor["time"] - 0.003, 0, monitor["dt"])  # from the checkpoint on
    checks.close("restart with another start: mass of the mean [kg]", (RHO_S * volume * anew.fields["mean_solids_fraction"]).sum(),
                 (weight * monitor["mass"]).sum() / weight.sum(), relative=1e-9)


program, checks = Program(), Checks("outputs: times, energies, columns, a moved directory")
run = program.run("small_bin.yaml", "whole", RUN)
check_times(checks, run)
check_energies(checks, "transport", run, True)
check_columns(checks, run)
algebraic = program.run("small_bin.yaml", "algebraic", {"granular_temperature": "algebraic", "end_time": 0.005, "friction_strain_rate_floor": 1})
check_energies(checks, "algebraic", algebraic, True)
constant = program.run("small_bin.yaml", "constant", {"granular_temperature": "constant", "end_time": 0.005})
check_energies(checks, "constant", constant, False)
air = program.run("small_bin.yaml", "air", {"gas": "incompressible", "end_time": 2e-4})
check_columns(checks, air)
check_averages(checks, program)
check_moved(checks, program, run)
checks.verdict()
