#include "cli/launched.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <filesystem>

#include "core/error.hpp"
#include "numerics/parallel.hpp"

namespace reeve::cli {
namespace {

std::string wish() {
  const char* value = std::getenv("REEVE_MPI");
  return value == nullptr ? "" : value;
}

// Beside the program, wherever both have been put.
std::filesystem::path module_of_mpi() {
  const std::filesystem::path program = std::filesystem::read_symlink("/proc/self/exe");
  return (program.parent_path() / REEVE_MODULES_FROM_PROGRAM / "reeve_mpi.so").lexically_normal();
}

std::string machine() {
  std::array<char, 256> name{};
  return ::gethostname(name.data(), name.size() - 1) == 0 ? name.data() : "a machine without name";
}

[[noreturn]] void refuse_to_connect(const std::string& why) {
  if (launched().rank == 0) throw InputError(why);
  throw Unconnected(why);
}

}  // namespace

Launch launched() {
  if (wish().empty()) return launch_in_environment();
  if (wish() == "off") return {};
  throw InputError({.where = "environment",
                    .what = "REEVE_MPI",
                    .value = wish(),
                    .expected = "off, or nothing",
                    .form = InputForm::equals});
}

std::string this_process() {
  const Launch launch = launch_in_environment();
  return fmt::format("rank {} of {}, on {}: ", launch.rank, launch.size, machine());
}

bool follows_another() { return wish() != "off" && launch_in_environment().rank > 0; }

void require_alone(const Launch& launch) {
  if (launch.size == 1) return;
  throw InputError(fmt::format(
      "started as {} processes, which would all do the same: only explore can be shared out "
      "(REEVE_MPI=off in the environment: each on its own)",
      launch.size));
}

std::unique_ptr<Processes> connected() {
  const std::filesystem::path module = module_of_mpi();
  std::error_code ignored;
  if (!std::filesystem::exists(module, ignored)) {
    refuse_to_connect(fmt::format(
        "started as {} processes, which would all write the same files: this reeve was built "
        "without MPI (there is no {}); install libopenmpi-dev and openmpi-bin and build it with "
        "-DREEVE_MPI=ON",
        launched().size, module.string()));
  }
  try {
    return connected_processes(module);
  } catch (const NoProcesses& error) {
    refuse_to_connect(
        fmt::format("started as {} processes, which find no way to talk to each other: {}",
                    launched().size, error.what()));
  }
}

int threads_of_one(const Processes& processes, int asked) {
  if (asked > 0) return asked;
  const auto cores = static_cast<int>(Workers(0).count());
  return std::max(1, cores / processes.sharing_cores());
}

}  // namespace reeve::cli
