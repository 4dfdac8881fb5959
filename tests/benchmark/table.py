#!/usr/bin/env python3
"""Makes the table of kernels_benchmark: table.py KERNELS.json [KERNELS.csv]; prints it too.

A row is a kernel: CPU time [ns] of an evaluation (closures) or of a cell (the others), with
  limit_share        bytes that it must move at least, per time, over the triad bandwidth of the same run
  over_residual      time of a Jacobian over that of the residual of the same problem, at most 8 is wanted
  over_coarsest      time per cell over that on the coarsest grid measured
  krylov             iterations of the solve
Of repetitions the least time counts: other programs can only add to it.
"""
import csv
import json
import sys

COLUMNS = ["kernel", "cells", "ns", "bytes_per_cell", "limit_share", "over_residual", "over_coarsest", "krylov"]
TO_NS = {"ns": 1, "us": 1e3, "ms": 1e6, "s": 1e9}


def fastest(results):
    """{name: result with the least CPU time}, in the order of the run."""
    best = {}
    for result in results:
        if result.get("run_type") == "aggregate":
            continue
        name = result["run_name"]
        if name not in best or result["cpu_time"] < best[name]["cpu_time"]:
            best[name] = result
    return best


def row_of(result, bandwidth):
    ns = result["cpu_time"] * TO_NS[result["time_unit"]]
    row = {"kernel": result["run_name"], "ns": ns / result.get("cells", 1)}
    for key in ("cells", "krylov"):
        if key in result:
            row[key] = int(result[key])
    if "bytes_per_cell" in result:
        row["bytes_per_cell"] = result["bytes_per_cell"]
        if bandwidth:
            row["limit_share"] = result["bytes_per_second"] / bandwidth
    return row


def add_ratios(rows):
    coarsest = {}
    for name, row in rows.items():
        group, _, problem = name.partition("/")
        if group not in ("residual", "jacobian"):
            continue
        row["over_coarsest"] = row["ns"] / coarsest.setdefault(name.rpartition("/")[0], row["ns"])
        if group == "jacobian" and "residual/" + problem in rows:
            row["over_residual"] = row["ns"] / rows["residual/" + problem]["ns"]


def main():
    with open(sys.argv[1]) as file:
        best = fastest(json.load(file)["benchmarks"])
    bandwidth = best.get("machine/triad", {}).get("bytes_per_second")
    flops = best.get("machine/multiply_add", {}).get("flops")
    limits = [("triad", bandwidth, "GB/s"), ("multiply-add", flops, "Gflop/s")]
    print("one core: " + ", ".join(f"{name} {value / 1e9:.1f} {unit}" for name, value, unit in limits if value))

    rows = {name: row_of(result, bandwidth) for name, result in best.items() if not name.startswith("machine/")}
    add_ratios(rows)
    table = [[f"{row[c]:.3g}" if isinstance(row.get(c), float) else str(row.get(c, "")) for c in COLUMNS]
             for row in rows.values()]
    widths = [max(len(line[k]) for line in [COLUMNS, *table]) for k in range(len(COLUMNS))]
    for line in [COLUMNS, *table]:
        print("  ".join(text.ljust(widths[k]) if k == 0 else text.rjust(widths[k]) for k, text in enumerate(line)))
    if len(sys.argv) > 2:
        with open(sys.argv[2], "w", newline="") as file:
            csv.writer(file).writerows([COLUMNS, *table])


if __name__ == "__main__":
    main()
