#!/usr/bin/env bash
# Builds the Docker image and runs a case in it: the proof that the image works.
set -euo pipefail

usage() {
  cat <<TEXT
Usage: scripts/docker.sh [--check] [CASE] [scree options]
  CASE     a case file of this checkout; default cases/guide/step6.yaml
  --check  parse the Dockerfile's commands by a shell and stop: needs no Docker

The run goes to out/docker, or to the -output_dir of the options, a path inside this checkout.

Environment: SCREE_IMAGE  name of the image; default scree
             SCREE_RANKS  number of MPI ranks; default 2
TEXT
}

fail() {
  echo "docker.sh: $*" >&2
  exit 1
}

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
dockerfile=$root/docker/Dockerfile

# Each RUN is a shell command, and each COPY names what is there.
check() {
  local commands
  commands=$(sed -e ':a' -e '/\\$/{N;s/\\\n//;ba' -e '}' "$dockerfile")
  grep '^RUN ' <<<"$commands" | sed 's/^RUN //' | sh -n || fail "a RUN of docker/Dockerfile is no shell command"
  while read -r _ from _; do
    [ -e "$root/$from" ] || fail "docker/Dockerfile copies $from, which is not there"
  done < <(grep '^COPY ' <<<"$commands")
  echo "docker.sh: $(grep -c '^RUN ' <<<"$commands") commands of docker/Dockerfile parse, what it copies is there"
}

case "${1:-}" in
  -h | --help) usage; exit 0 ;;
  --check) check; exit 0 ;;
  -*) usage >&2; exit 2 ;;
esac
case_file=${1:-cases/guide/step6.yaml}
[ $# -eq 0 ] || shift
[ -f "$root/$case_file" ] || fail "no case file $case_file in $root"
check
command -v docker >/dev/null || fail "no docker on the PATH: nothing was built"
docker info >/dev/null 2>&1 || fail "docker does not reach its daemon (docker info says why): nothing was built"

output=out/docker
arguments=("$@")
for ((i = 0; i < $#; ++i)); do
  [ "${arguments[i]}" != -output_dir ] || output=${arguments[i + 1]:-}
done
[[ " $* " == *" -output_dir "* ]] || arguments+=(-output_dir "$output")

image=${SCREE_IMAGE:-scree}
docker build -f "$dockerfile" -t "$image" "$root"
docker run --rm -u "$(id -u):$(id -g)" -v "$root:/data" --entrypoint mpirun "$image" \
  $([ "$(id -u)" -ne 0 ] || echo --allow-run-as-root) -n "${SCREE_RANKS:-2}" scree "$case_file" "${arguments[@]}"
[ -s "$root/$output/summary.json" ] || fail "the run left no $output/summary.json"
echo "docker.sh: the image $image works; the run is in $output"
