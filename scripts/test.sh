#!/usr/bin/env bash
# Runs the test suite from a fresh checkout: installs what is missing, builds, tests.
set -euo pipefail

usage() {
  cat <<TEXT
Usage: scripts/test.sh [ctest options]
Examples: scripts/test.sh              # everything
          scripts/test.sh -L unit      # one label
          scripts/test.sh -R Friction  # by name

Labels: unit, jacobian, manufactured, verification, stability, robustness, regression, extension. Tests of the Python
package (-R python) have the label unit, or regression where they run the program.

Environment: SCREE_BUILD_DIR, CMAKE_BUILD_PARALLEL_LEVEL  see scripts/build.sh
TEXT
}

case "${1:-}" in
  -h | --help) usage; exit 0 ;;
esac

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
"$root/scripts/install_dependencies.sh"
"$root/scripts/build.sh" ${SCREE_BUILD_TARGETS:-}

# nproc takes OMP_NUM_THREADS for the number of cores. One test more than cores: their scripts wait for runs to start.
tests=$(($(env -u OMP_NUM_THREADS nproc) + 1))
# Several small MPI jobs share the cores: no pinning (each would take core 0), no threads, root allowed in containers.
export OMP_NUM_THREADS=1
export OMPI_MCA_hwloc_base_binding_policy=none OMPI_MCA_rmaps_base_oversubscribe=1
export OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1
exec ctest --test-dir "${SCREE_BUILD_DIR:-$root/build}" --output-on-failure --no-tests=error -j "$tests" "$@"
