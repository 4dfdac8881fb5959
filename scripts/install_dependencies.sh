#!/usr/bin/env bash
# Installs what Scree needs from the packages of Debian 12, Ubuntu 24.04 or Fedora; does nothing where all is there.
set -euo pipefail

usage() {
  cat <<TEXT
Usage: scripts/install_dependencies.sh [--dev] [--list]
  --dev    also clang-format, clang-tidy, valgrind, and what tests of scripts/scree use: a browser and pip
  --list   print the packages and stop
TEXT
}

dev=false
list_only=false
for argument in "$@"; do
  case "$argument" in
    --dev) dev=true ;;
    --list) list_only=true ;;
    -h | --help) usage; exit 0 ;;
    *) usage >&2; exit 2 ;;
  esac
done

# /etc/os-release, or another file in its place to see what a system would get.
os_release=${SCREE_OS_RELEASE:-/etc/os-release}
ID=unknown VERSION_ID=
# shellcheck disable=SC1090
[ ! -r "$os_release" ] || . "$os_release"

debian_packages() {
  packages=(
    build-essential cmake ninja-build pkg-config
    openmpi-bin libopenmpi-dev
    petsc-dev libpetsc-real-dev slepc-dev libslepc-real-dev libhypre-dev libmetis-dev libopenblas0-serial
    libhdf5-openmpi-dev libudunits2-dev libyaml-cpp-dev nlohmann-json3-dev
    libgtest-dev libgmock-dev libbenchmark-dev
    python3-numpy python3-scipy python3-matplotlib python3-h5py python3-xarray python3-pandas python3-yaml python3-pil
    python3-jsonschema
  )
  dev_packages=(clang-format clang-tidy valgrind chromium python3-pip)
}

# SLEPc is not among Fedora's packages: tests that need it are left out there.
fedora_packages() {
  packages=(
    gcc-c++ cmake ninja-build pkgconf-pkg-config
    openmpi openmpi-devel
    petsc-openmpi-devel hdf5-openmpi-devel udunits2-devel yaml-cpp-devel json-devel
    gtest-devel gmock-devel google-benchmark-devel
    python3-numpy python3-scipy python3-matplotlib python3-h5py python3-xarray python3-pandas python3-pyyaml
    python3-pillow python3-jsonschema
  )
  dev_packages=(clang-tools-extra valgrind chromium python3-pip)
}

debian_packages
known=true
case "$ID" in
  debian) [ "$VERSION_ID" != 12 ] || packages=("${packages[@]/libslepc-real-dev/libslepc-real3.18-dev}") ;;
  ubuntu) dev_packages=(clang-format clang-tidy valgrind python3-pip) ;; # its chromium is no package but a snap
  fedora) fedora_packages ;;
  *) known=false ;;
esac
! $dev || packages+=("${dev_packages[@]}")
if $list_only; then
  printf '%s\n' "${packages[@]}"
  exit 0
fi
if ! $known; then
  echo "install_dependencies.sh: no list of packages for this system ($ID $VERSION_ID); install by hand what on Debian is:" >&2
  printf '  %s\n' "${packages[@]}" >&2
  echo "PETSc may also come from Spack, conda-forge or source: see Build in src/README.md." >&2
  exit 1
fi

as_root() {
  if [ "$(id -u)" -eq 0 ]; then
    "$@"
  elif command -v sudo >/dev/null; then
    sudo "$@"
  else
    echo "install_dependencies.sh: needs root or sudo for: $*" >&2
    return 1
  fi
}

if [ "$ID" = fedora ]; then
  missing=()
  for package in "${packages[@]}"; do
    rpm -q --quiet --whatprovides "$package" || missing+=("$package")
  done
  if [ ${#missing[@]} -gt 0 ]; then
    echo "Installing: ${missing[*]}"
    as_root dnf -q -y install --setopt=install_weak_deps=False "${missing[@]}"
  fi
  command -v mpicc >/dev/null || echo "Now: module load mpi/openmpi-$(uname -m), in a new shell" >&2
  exit 0
fi

missing=()
for package in "${packages[@]}"; do
  [ "$(dpkg-query -W -f '${db:Status-Status}' "$package" 2>/dev/null)" = installed ] || missing+=("$package")
done
if [ ${#missing[@]} -gt 0 ]; then
  echo "Installing: ${missing[*]}"
  as_root apt-get -q -o DPkg::Lock::Timeout=300 update
  as_root env DEBIAN_FRONTEND=noninteractive \
    apt-get -q -y -o DPkg::Lock::Timeout=300 install --no-install-recommends "${missing[@]}"
fi

# The ranks are the parallelism. A threaded BLAS, where there is one, has the higher priority and would win.
multiarch=$(gcc -print-multiarch)
for library in blas lapack; do
  link=lib$library.so.3-$multiarch
  serial=/usr/lib/$multiarch/openblas-serial/lib$library.so.3
  state=$(update-alternatives --query "$link")
  if grep -qx "Value: $serial" <<<"$state"; then
    continue
  elif grep -qx "Status: auto" <<<"$state"; then
    echo "Choosing the serial OpenBLAS for $link"
    as_root update-alternatives --set "$link" "$serial" || echo "left as it is; set OMP_NUM_THREADS=1 for your runs" >&2
  else
    echo "$link was chosen by hand and stays; the serial OpenBLAS suits Scree best" >&2
  fi
done
