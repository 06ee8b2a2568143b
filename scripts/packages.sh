# shellcheck shell=bash disable=SC2034
# Sourced by run and .ci/run: which Debian packages are needed for what, and how to get
# them.
PACKAGES_BUILD=(g++ cmake ninja-build git libeigen3-dev libnlopt-cxx-dev libnlopt-dev
  libboost-graph-dev libtbb-dev libfmt-dev libcli11-dev nlohmann-json3-dev
  libtomlplusplus-dev librandom123-dev libkainjow-mustache-dev libtinyxml2-dev zlib1g-dev
  libsqlitecpp-dev libsqlite3-dev)
# npm fetches the chart library of the pages. Debian's npm depends on some 340 packages node-*, which are
# most of what is installed; the node of some machines has npm as part of it.
PACKAGES_NPM=(nodejs npm)
PACKAGES_PAGES=()
command -v npm >/dev/null || PACKAGES_PAGES=("${PACKAGES_NPM[@]}")
# sqlite3 for the lines of docs/store.md. Chromium alone brings no font, and a page without letters
# fits everywhere.
PACKAGES_TEST=(libgtest-dev libgmock-dev librapidcheck-dev libmujoco-dev python3 sqlite3 chromium
  fonts-liberation fonts-dejavu-core)
# For the Python module and its tests, which also install it with pip. SciPy is for a notebook, jsonschema for
# docs/schema.
PACKAGES_PYTHON=(pybind11-dev python3-dev python3-numpy python3-pandas)
PACKAGES_PYTHON_TEST=(python3-pytest python3-mypy python3-matplotlib python3-pip python3-venv
  python3-setuptools python3-wheel python3-scipy python3-jsonschema)
# For `mpirun reeve` and its tests; where they are not installed neither is built.
PACKAGES_MPI=(libopenmpi-dev openmpi-bin)
# For ./run package: CPack asks file which of its files are programs, and dpkg-shlibdeps what they need.
PACKAGES_PACKAGE=(dpkg-dev file)
PACKAGES_CI=(clang-format clang-tidy)
# For scripts/fuzz.
PACKAGES_FUZZ=(clang libclang-rt-14-dev)
# For the programs under bench/ and their comparisons, and for bench/instructions; nothing here
# installs these unasked.
PACKAGES_BENCH=(libbenchmark-dev nauty python3 python3-numpy python3-scipy)
PACKAGES_PROFILE=(valgrind)

# True if a line on stderr can be written again and again.
is_live() { [[ -t 2 && ${TERM:-dumb} != dumb ]]; }

# tell <sentence>: on stderr, in place of a progress line that may stand there.
tell() {
  local wipe=
  ! is_live || wipe=$'\r\e[K'
  printf '%sreeve: %s\n' "$wipe" "$1" >&2
}

# followed <what> <command...>: runs the command; `run` defines it anew to tell how far it is.
followed() { "${@:2}"; }

# install_packages <log> <package...>: installs those that are missing, and says before how many
# packages and megabytes that is. One query to dpkg when none is missing. Without apt-get it leaves the
# verdict to CMake.
install_packages() {
  local log=$1 installed package plan sudo=()
  shift
  command -v apt-get >/dev/null && command -v dpkg-query >/dev/null || return 0
  # dpkg-query fails when it has never heard of one of them; what it prints still counts.
  # shellcheck disable=SC2016
  installed=" $(dpkg-query -W -f '${db:Status-Status}=${Package} ' "$@" 2>/dev/null || true)"
  local missing=()
  for package in "$@"; do
    [[ $installed == *" installed=$package "* ]] || missing+=("$package")
  done
  ((${#missing[@]})) || return 0

  if ((EUID != 0)); then
    if ! command -v sudo >/dev/null; then
      tell "not root and no sudo here; please install: ${missing[*]}"
      return 1
    fi
    sudo=(sudo)
    # It asks for the password here, where no progress line is written over its question.
    tell "needs packages, which sudo installs: ${missing[*]}"
    sudo -v || return 1
  fi
  local install=(apt-get install -y --no-install-recommends -o DPkg::Lock::Timeout=300 "${missing[@]}")
  apt_quietly() { "${sudo[@]}" env DEBIAN_FRONTEND=noninteractive "$@" >>"$log" 2>&1 </dev/null; }
  if followed "reading the lists of packages" apt_quietly apt-get update; then
    # Printing the addresses of what it would fetch, apt-get installs nothing.
    plan=$(LC_ALL=C "${install[@]}" --print-uris 2>>"$log" </dev/null | sed -nE "
      s/^.* ([0-9]+) newly installed.*/\\1 packages/p
      s/^Need to get (.*) of archives.*/, \\1 to fetch/p
      s/^After this operation, (.*) of additional disk space.*/, \\1 on disk/p" | tr -d '\n') || true
    tell "installing ${missing[*]}${plan:+ ($plan)} …"
    followed "installing packages" apt_quietly "${install[@]}" && return
  fi
  tail -n 15 "$log" >&2
  tell "apt-get could not install: ${missing[*]}"
  return 1
}
