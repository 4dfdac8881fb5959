#!/usr/bin/env bash
# Prints the python3 that Scree's scripts run with: $SCREE_PYTHON, or the first on the PATH that has their modules.
set -euo pipefail

modules=(numpy scipy matplotlib h5py xarray pandas yaml PIL)

lacks() {
  "$1" -c 'import importlib.util, sys
print(*(name for name in sys.argv[1:] if importlib.util.find_spec(name) is None))' "${modules[@]}"
}

if [ -n "${SCREE_PYTHON:-}" ]; then
  candidates=("$SCREE_PYTHON")
else
  mapfile -t candidates < <(type -ap python3)
fi
said=
for python in "${candidates[@]}"; do
  missing=$(lacks "$python" 2>&1) || missing="does not start"
  if [ -z "$missing" ]; then
    echo "$python"
    exit 0
  fi
  said+=$'\n'"  $python: $missing"
done
cat >&2 <<TEXT
python.sh: no python3 with the modules that scripts/scree needs. Missing are:${said:-" python3 itself"}
scripts/install_dependencies.sh installs them for the system's python3; elsewhere: pip install ./scripts.
SCREE_PYTHON names the interpreter to take.
TEXT
exit 1
