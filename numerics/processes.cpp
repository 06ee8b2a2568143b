#include "numerics/processes.hpp"

#include <dlfcn.h>

#include <charconv>
#include <cstdlib>
#include <string_view>

namespace reeve::numerics {
namespace {

std::optional<int> number_in_environment(const char* name) {
  const char* value = std::getenv(name);
  if (value == nullptr) return std::nullopt;
  const std::string_view text(value);
  int number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc{} || end != text.data() + text.size() || number < 0) return std::nullopt;
  return number;
}

struct LaunchVariables {
  const char* rank;
  const char* size;
};

}  // namespace

Launch launch_in_environment() {
  for (const auto& [rank_name, size_name] :
       {LaunchVariables{"OMPI_COMM_WORLD_RANK", "OMPI_COMM_WORLD_SIZE"},
        LaunchVariables{"PMI_RANK", "PMI_SIZE"},
        LaunchVariables{"PMIX_RANK", "SLURM_STEP_NUM_TASKS"}}) {
    const std::optional<int> rank = number_in_environment(rank_name);
    const std::optional<int> size = number_in_environment(size_name);
    if (rank && size && *rank < *size) return {*rank, *size};
  }
  return {};
}

std::unique_ptr<Processes> connected_processes(const std::filesystem::path& module) {
  // Open MPI loads further parts, some of which look for its symbols among those of all.
  void* loaded = ::dlopen(module.c_str(), RTLD_NOW | RTLD_GLOBAL);
  if (loaded == nullptr) throw NoProcesses(::dlerror());
  void* function = ::dlsym(loaded, connecting_function);
  if (function == nullptr) throw NoProcesses(::dlerror());
  std::unique_ptr<Processes> processes(reinterpret_cast<ConnectingFunction>(function)());
  const Launch launch = launch_in_environment();
  if (processes->size() == launch.size && processes->rank() == launch.rank) return processes;
  throw NoProcesses("the launcher is not of the MPI that it was built with");
}

}  // namespace reeve::numerics
