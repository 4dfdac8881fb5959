#!/usr/bin/env bash
# Configures (once) and builds Scree in release mode with Ninja.
set -euo pipefail

usage() {
  cat <<TEXT
Usage: scripts/build.sh [-DOPTION=VALUE ...] [TARGET ...]
  -D...    options for CMake, for example -DSCREE_NATIVE=OFF
  TARGET   what to build, for example scree; all without one

Environment: SCREE_BUILD_DIR             where to build; default build/ in the source directory
             CMAKE_BUILD_PARALLEL_LEVEL  compilers at a time; default the number of cores
TEXT
}

options=()
targets=()
for argument in "$@"; do
  case "$argument" in
    -h | --help) usage; exit 0 ;;
    -D*) options+=("$argument") ;;
    -*) usage >&2; exit 2 ;;
    *) targets+=("$argument") ;;
  esac
done

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
build=${SCREE_BUILD_DIR:-$root/build}
export CMAKE_BUILD_PARALLEL_LEVEL=${CMAKE_BUILD_PARALLEL_LEVEL:-$(env -u OMP_NUM_THREADS nproc)}

if [ ! -f "$build/build.ninja" ] || [ ${#options[@]} -gt 0 ]; then
  cmake -S "$root" -B "$build" -G Ninja -DCMAKE_BUILD_TYPE=Release "${options[@]}"
fi
cmake --build "$build" ${targets:+--target "${targets[@]}"}
