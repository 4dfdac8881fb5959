#!/usr/bin/env bash
# Runs a case from a fresh checkout: installs what is missing, builds, runs, draws the plots, writes the report.
set -euo pipefail

usage() {
  cat <<TEXT
Usage: scripts/run.sh CASE [VARIANT.yaml ...] [scree options]
  CASE      a directory that holds a case.yaml, or a case file
  VARIANT   files of overrides (for scree: -options_file_yaml), given as a path or by their name in the case's directory

Examples: scripts/run.sh cases/bin_discharge
          scripts/run.sh cases/bin_discharge -friction_tau 1e-2 -output_dir out/tau2
          SCREE_RANKS=4 scripts/run.sh cases/bin_discharge with_air.yaml

Without -output_dir the run goes to out/<case>[_<variant>], or to out/<case>.2, .3 ... if that holds a run already.
What it says is kept there in `log`. Plots come from scripts/plot_<case>.py, where there is one; report.html, which
a browser shows, from scripts/scree-report.

Environment: SCREE_RANKS  number of MPI ranks; default 2
             SCREE_BUILD_DIR, CMAKE_BUILD_PARALLEL_LEVEL  see scripts/build.sh
TEXT
}

fail() {
  echo "run.sh: $*" >&2
  exit 1
}

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
case "${1:-}" in
  "") usage >&2; exit 2 ;;
  -h | --help) usage; exit 0 ;;
  -*) fail "the case comes first, then options: $1" ;;
esac

case_file=${1%/}
shift
[ ! -d "$case_file" ] || case_file+=/case.yaml
[ -f "$case_file" ] || fail "no such case: $case_file (see $root/cases)"
case_directory=$(cd "$(dirname "$case_file")" && pwd)
case_name=$(basename "$case_directory")
run_name=$case_name
stem=$(basename "${case_file%.*}")
[ "$stem" = case ] || run_name+=_$stem

overrides=()
while [[ "${1:-}" == *.yaml || "${1:-}" == *.yml ]]; do
  variant=$1
  [ -f "$variant" ] || variant=$case_directory/$1
  [ -f "$variant" ] || fail "no such variant: $1 (looked in . and $case_directory)"
  overrides+=(-options_file_yaml "$variant")
  run_name+=_$(basename "${variant%.*}")
  shift
done

ranks=${SCREE_RANKS:-2}
[[ "$ranks" =~ ^[1-9][0-9]*$ ]] || fail "SCREE_RANKS is a positive number, not '$ranks'"

output=
arguments=("$@")
for ((i = 0; i < $#; ++i)); do
  [ "${arguments[i]}" != -output_dir ] || output=${arguments[i + 1]:-}
done
if [ -z "$output" ]; then
  first=$(realpath -m --relative-to=. "$root/out/$run_name")
  output=$first
  for ((i = 2; ; ++i)); do
    [ -n "$(ls -A "$output" 2>/dev/null)" ] || break
    output=$first.$i
  done
  [ "$output" = "$first" ] || echo "$first holds a run already; this one goes to $output"
  arguments+=(-output_dir "$output")
fi

"$root/scripts/install_dependencies.sh"
"$root/scripts/build.sh" scree
python=$("$root/scripts/python.sh")

launcher=(mpirun -n "$ranks")
if [[ "$(mpirun --version 2>&1)" == *"Open MPI"* ]]; then  # others neither pin nor refuse
  launcher+=(--bind-to none)
  [ "$(id -u)" -ne 0 ] || launcher+=(--allow-run-as-root)
  [ "$ranks" -le "$(env -u OMP_NUM_THREADS nproc)" ] || launcher+=(--oversubscribe)
fi
export OMP_NUM_THREADS=1
export PYTHONPATH=$root/scripts${PYTHONPATH:+:$PYTHONPATH}
command=("${launcher[@]}" "${SCREE_BUILD_DIR:-$root/build}/bin/scree" "$case_file" "${overrides[@]}" "${arguments[@]}")
echo "Running: ${command[*]}"

# mpirun answers SIGTERM and Ctrl-C by killing its ranks within two seconds, but forwards SIGUSR1. It runs in a process
# group of its own, so that Ctrl-C comes here alone.
signal=USR1
stop_solver() {
  if [ "$signal" = USR1 ]; then
    echo "Stopping: scree writes a checkpoint and ends; once more ends it at once" >&2
  fi
  kill -"$signal" "$solver" 2>/dev/null || true
  signal=TERM
}
set -m
"$python" -m scree.logged "$output" "${command[@]}" </dev/null &
solver=$!
trap stop_solver TERM INT
while :; do
  wait "$solver" && status=0 || status=$?
  kill -0 "$solver" 2>/dev/null || break
done
trap - TERM INT
[ "$status" -eq 0 ] || exit "$status"

plot=$root/scripts/plot_$case_name.py
if [ -f "$plot" ] && [ -f "$output/monitor.csv" ]; then
  if "$python" "$plot" "$output"; then
    echo "Plots: $output/plots"
  else
    echo "run.sh: the plots failed; the run is whole" >&2
  fi
fi
"$python" "$root/scripts/scree-report" "$output" || echo "run.sh: the report failed; the run is whole" >&2
