#!/usr/bin/env bash
# Makes all figures of the paper, the findings beside it, and the table of numbers.
set -euo pipefail

usage() {
  cat <<TEXT
Usage: scripts/paper/all.sh [options of the scripts, such as --grid coarse --end-time 0.3 --out DIR --ranks 1]

Figures 1 to 13, flutter, starts, parameters, convergence and page_numbers (see scripts/paper), one after the other,
into out/paper. Runs that are there are reused, pictures newer than their runs are kept, a run that was interrupted
goes on from its last checkpoint: start it again after Ctrl-C. Runs go one at a time on 2 ranks, on the coarse grid
on one. --grid holds for the figures, flutter and starts and is the finest of convergence; parameters is always on the
coarse grid. scripts/paper/paper_runs.py lists the runs and what they are thought to take.
TEXT
}

here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
program=${SCREE_BUILD_DIR:-$here/../../build}/bin/scree
arguments=("$@")
for ((i = 0; i < $#; ++i)); do
  case ${arguments[i]} in
    -h | --help) usage; exit 0 ;;
    --program) program=${arguments[i + 1]:-} ;;
    --program=*) program=${arguments[i]#*=} ;;
  esac
done
if [ ! -x "$program" ]; then
  echo "all.sh: no program '$program': scripts/build.sh builds it, --program names another" >&2
  exit 1
fi

python=$("$here/../python.sh")
names=(figure_{01..13} flutter starts parameters convergence page_numbers)
failed=()
running=
stop() {
  trap '' INT TERM
  echo "all.sh: stopping; start it again to go on" >&2
  [ -z "$running" ] || { kill -TERM "$running" 2>/dev/null || true; wait "$running" || true; }
  exit 130
}
trap stop INT TERM

left() { "$python" "$here/paper_runs.py" --left "${arguments[@]}"; }
left >/dev/null # says what is wrong with the options, once

for ((i = 0; i < ${#names[@]}; ++i)); do
  name=${names[i]}
  own=("${arguments[@]}" --skip-done)
  [ "$name" != parameters ] || own+=(--grid coarse)
  echo "$(date +%T) [$((i + 1))/${#names[@]}] $name; $(left)"
  set -m # a process group of its own, so that Ctrl-C comes here alone
  "$python" "$here/$name.py" "${own[@]}" </dev/null &
  running=$!
  set +m
  wait "$running" || failed+=("$name")
  running=
done
[ ${#failed[@]} -eq 0 ] || { echo "all.sh: failed: ${failed[*]}" >&2; exit 1; }
echo "$(date +%T) all done; $(left)"
