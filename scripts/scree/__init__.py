"""Scree from Python: runs cases, opens what they leave, draws it, sweeps over options.

    import scree
    run = scree.run("cases/bin_discharge", ranks=2, end_time=0.5)     # or scree.open("out/bin_discharge")
    run.monitor.plot("time", "discharge_rate")                        # pandas
    run.fields.solids_fraction.isel(time=-1).plot()                   # xarray
    run.plot("solids_fraction", time=0.3).savefig("nu.png")
    table = scree.sweep("cases/bin_discharge", {"friction_tau": [1e-3, 1e-2]})

In place: PYTHONPATH=scripts. Installed: `pip install --no-build-isolation scripts/`, which needs no network; as Debian
keeps pip out of its own Python, in an environment of `python3 -m venv --system-site-packages DIRECTORY`. All that the
package needs is in Debian, see scripts/install_dependencies.sh. Commands: scree-sweep and scree-report, in place
scripts/scree-sweep and scripts/scree-report."""
import importlib

#: Loaded when they are asked for: pandas and xarray take a second, which scripts that read arrays need not wait for.
HOMES = {"Run": "results", "open": "results", "RunError": "program", "check": "program", "run": "program",
         "sweep": "sweeps"}
__all__ = list(HOMES)


def __getattr__(name):
    if name not in HOMES:
        raise AttributeError(f"module scree has no attribute {name}")
    return getattr(importlib.import_module(f"scree.{HOMES[name]}"), name)
