# shellcheck shell=bash disable=SC2034
# Sourced by run and .ci/run: which Debian packages are needed for what, and how to get
# them.
PACKAGES_BUILD=(g++ cmake ninja-build git libeigen3-dev libnlopt-cxx-dev libnlopt-dev
  libboost-graph-dev libtbb-dev libfmt-dev libcli11-dev nlohmann-json3-dev
  libtomlplusplus-dev librandom123-dev libkainjow-mustache-dev libtinyxml2-dev zlib1g-dev
  libsqlitecpp-dev libsqlite3-dev)
# npm comes with the node of some machines, as part of it.
command -v npm >/dev/null || PACKAGES_BUILD+=(nodejs npm)
# sqlite3 for the lines of docs/store.md. Chromium alone brings no font, and a page without letters
# fits everywhere.
PACKAGES_TEST=(libgtest-dev librapidcheck-dev libmujoco-dev python3 sqlite3 chromium
  fonts-liberation fonts-dejavu-core)
# For the Python module and its tests, which also install it with pip. SciPy is for a notebook.
PACKAGES_PYTHON=(pybind11-dev python3-dev python3-numpy python3-pandas)
PACKAGES_PYTHON_TEST=(python3-pytest python3-mypy python3-matplotlib python3-pip python3-venv
  python3-setuptools python3-wheel python3-scipy)
# For `mpirun reeve` and its tests; where they are not installed neither is built.
PACKAGES_MPI=(libopenmpi-dev openmpi-bin)
PACKAGES_CI=(clang-format clang-tidy)
# For scripts/fuzz.
PACKAGES_FUZZ=(clang libclang-rt-14-dev)
# For the programs under bench/ and their comparisons, and for bench/instructions; nothing here
# installs these unasked.
PACKAGES_BENCH=(libbenchmark-dev nauty python3 python3-numpy python3-scipy)
PACKAGES_PROFILE=(valgrind)

# install_packages <log> <package...>: installs those that are missing. One query to dpkg
# when none is. Without apt-get it leaves the verdict to CMake.
install_packages() {
  local log=$1 installed package sudo=()
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

  echo "reeve: installing ${missing[*]} …" >&2
  if ((EUID != 0)); then
    if ! command -v sudo >/dev/null; then
      echo "reeve: not root and no sudo here; please install: ${missing[*]}" >&2
      return 1
    fi
    sudo=(sudo)
  fi
  if ! {
    "${sudo[@]}" apt-get update &&
      "${sudo[@]}" env DEBIAN_FRONTEND=noninteractive apt-get install -y \
        --no-install-recommends -o DPkg::Lock::Timeout=300 "${missing[@]}"
  } >>"$log" 2>&1 </dev/null; then
    tail -n 15 "$log" >&2
    echo "reeve: apt-get could not install: ${missing[*]}" >&2
    return 1
  fi
}
