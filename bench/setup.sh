# shellcheck shell=bash disable=SC2154
# Sourced by bench/compare, bench/instructions and bench/page_cost, with `root` set: packages, then
# the preset bench. Exit 3 when that fails.
# shellcheck source=scripts/packages.sh
source "$root/scripts/packages.sh"
build=$root/build/bench
log=$root/build/bench.log

# Another python may come first in PATH, without NumPy. One thread, whatever its BLAS thinks.
python() { OMP_NUM_THREADS=1 OPENBLAS_NUM_THREADS=1 /usr/bin/python3 "$@"; }

# build_bench <targets...> -- <packages besides those of the build...>
build_bench() {
  local targets=() cache=$build/CMakeCache.txt
  while [[ $1 != -- ]]; do
    targets+=("$1")
    shift
  done
  shift
  mkdir -p -- "$root/build"
  # One setup and build at a time, as in ./run.
  exec 9>"$root/build/.lock"
  flock 9
  : >"$log"
  install_packages "$log" "${PACKAGES_BUILD[@]}" "$@" || exit 3
  # A copied or moved checkout: CMake refuses the old folder's cache.
  if [[ -e $cache ]] && ! grep -qxF "CMAKE_HOME_DIRECTORY:INTERNAL=$root" "$cache"; then
    rm -rf -- "$build"
  fi
  echo "reeve: building …" >&2
  (cd -- "$root" && cmake --preset bench && cmake --build "$build" --target "${targets[@]}") \
    >>"$log" 2>&1 || {
    tail -n 40 "$log" >&2
    echo "reeve: the build failed; all it said is in $log" >&2
    exit 3
  }
  exec 9>&-
}
