#!/usr/bin/env bash
# Time per cell of closures, residual, Jacobian and preconditioner on one core, beside the limits of the machine.
set -euo pipefail

usage() {
  cat <<TEXT
Usage: scripts/benchmark.sh [options of Google Benchmark]
Examples: scripts/benchmark.sh                                        # everything, some minutes
          scripts/benchmark.sh --benchmark_filter='machine|/bin/'     # part of it
          scripts/benchmark.sh --benchmark_repetitions=5              # the least of five times counts

Writes kernels.json (as Google Benchmark has it) and kernels.csv (a row a kernel), and prints the latter.
Environment: SCREE_BUILD_DIR      see scripts/build.sh
             SCREE_BENCHMARK_DIR  where to write; default out/benchmark
TEXT
}

case "${1:-}" in
  -h | --help) usage; exit 0 ;;
esac

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
build=${SCREE_BUILD_DIR:-$root/build}
out=${SCREE_BENCHMARK_DIR:-$root/out/benchmark}
python=$("$root/scripts/python.sh")
"$root/scripts/build.sh" kernels_benchmark
mkdir -p "$out"
export OMP_NUM_THREADS=1
"$build/bin/kernels_benchmark" "$root/cases" --benchmark_out_format=json --benchmark_out="$out/kernels.json" \
  --benchmark_min_time=0.3 "$@" >"$out/kernels.log" || { tail -n 3 "$out/kernels.log" >&2; exit 1; }
"$python" "$root/tests/benchmark/table.py" "$out/kernels.json" "$out/kernels.csv"
