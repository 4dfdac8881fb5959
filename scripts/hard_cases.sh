#!/usr/bin/env bash
# Runs the long hard cases, which are no part of the test suite: a quarter of an hour on 2 ranks, hours on finer grids.
set -euo pipefail

usage() {
  cat <<TEXT
Usage: scripts/hard_cases.sh [-o OUT] [NAME ...]
  -o OUT  where results go: OUT/NAME/checks.json and the runs; default out/hard_cases
  NAME    which ones; default all:
    lip_long     H9: rate of discharge on 2, 1, .5 mm cells, order, extrapolated value, mirror symmetry
    fine_bin_long  H10: 100 um bin with air for 5 s, and with its bottom closed
    bubble_symmetry_long  H11: bubble on the full width, 3 and 1.5 mm cells
    collapse_long  H18: columns of aspect ratio 1, 3, 7
    flutter_long H8: the plug of the bin with friction coupled and lagged

What is done (OUT/NAME/checks.json is there) is skipped, what was interrupted starts anew; the exit code says whether all
checks hold. Each runs the program on SCREE_RANKS ranks, one case after the other.

Environment: SCREE_RANKS  number of MPI ranks, at most as many as cores you want busy; default 2
             SCREE_LIP_REFINE  grids of lip_long as divisors of 2 mm; default "1 2 4", "1 2 4 8" adds .25 mm
             SCREE_LIP_END, SCREE_FINE_END  simulated times [s]; default .35, 5
             SCREE_BUBBLE_REFINE  grids of bubble_symmetry_long as divisors of 3 mm; default "1 2", "1 2 4" adds .75 mm
             SCREE_BUBBLE_END  simulated time [s]; default .5
             SCREE_BUILD_DIR  see scripts/build.sh
TEXT
}

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
all=(lip_long fine_bin_long bubble_symmetry_long collapse_long flutter_long)
out=$root/out/hard_cases
while [ $# -gt 0 ]; do
  case $1 in
    -h | --help) usage; exit 0 ;;
    -o) out=${2:?"-o needs a directory"}; shift 2 ;;
    -*) usage >&2; exit 2 ;;
    *) break ;;
  esac
done
[ $# -gt 0 ] || set -- "${all[@]}"
for name in "$@"; do
  [[ " ${all[*]} " == *" $name "* ]] || { echo "hard_cases.sh: no such case: $name (there are: ${all[*]})" >&2; exit 2; }
done

scree=${SCREE_BUILD_DIR:-$root/build}/bin/scree
[ -x "$scree" ] || { echo "hard_cases.sh: no $scree: scripts/build.sh builds it" >&2; exit 1; }
python=$("$root/scripts/python.sh")
ranks=${SCREE_RANKS:-2}
launcher=(mpirun)
if [[ "$(mpirun --version 2>&1)" == *"Open MPI"* ]]; then  # others neither pin nor refuse
  launcher+=(--bind-to none --oversubscribe)
  [ "$(id -u)" -ne 0 ] || launcher+=(--allow-run-as-root)
fi
export OMP_NUM_THREADS=1 OMPI_MCA_mpi_yield_when_idle=1
export PYTHONPATH=$root/tests/support PYTHONDONTWRITEBYTECODE=1 PYTHONUNBUFFERED=1

# An interrupt ends the case under way with all its ranks; its directory is left, without checks.json.
running=
stop() {
  [ -z "$running" ] || kill -TERM -- "-$running" 2>/dev/null || true
  echo "hard_cases.sh: stopped; run it again to go on" >&2
  exit 130
}
trap stop INT TERM

mkdir -p "$out"
failed=0
for name in "$@"; do
  if [ -f "$out/$name/checks.json" ]; then
    echo "$name: done already, in $out/$name"
    continue
  fi
  echo "$(date +%T) $name: runs on $ranks ranks, log in $out/$name.log"
  set -m
  script=$(find "$root/tests/stability" -name "$name.py")
  "$python" "$script" --scree "$scree" --ranks "$ranks" --work "$out/$name" -- \
    "${launcher[@]}" > >(tee "$out/$name.log" | sed -u "s/^/  /") 2>&1 </dev/null &
  running=$!
  set +m
  wait "$running" && status=0 || status=$?
  running=
  [ "$status" -eq 0 ] || failed=1
  echo "$(date +%T) $name: exit code $status"
done
exit "$failed"
