"""Runs that may fail, and the largest fixed step that a case works with."""
import subprocess


def attempt(program, case, name, options, timeout):
    """The run, or None where the program ends with an error or takes longer than `timeout` [s]."""
    try:
        run = program.run(case, name, options, must_work=False, timeout=timeout)
    except subprocess.TimeoutExpired:
        return None
    return run if run.code == 0 else None


def largest_step(program, case, name, options, steps, good, timeout=240):
    """Runs `case` with each of the ascending `steps` [s] until one fails: the program ends with an error, cuts a step, or
    good(run) is false. Returns (largest that works, its run), or (None, None)."""
    best = (None, None)
    for dt in steps:
        fixed = {**options, "time_step_adaptive": "no", "time_step_initial": dt}
        run = attempt(program, case, f"{name}_dt_{dt:g}", fixed, timeout)
        if not run or run.monitor["rejected_solver"].sum() or not good(run):
            break
        best = (dt, run)
    return best
