#include "cli/terminal.hpp"

#include <sys/ioctl.h>
#include <unistd.h>

#include <charconv>
#include <cstdlib>
#include <string>

namespace reeve::cli {
namespace {

std::string variable(const char* name) {
  const char* value = std::getenv(name);
  return value == nullptr ? "" : value;
}

// The window's own, else what the shell says, else what terminals used to have.
std::size_t width_of(int descriptor) {
  winsize window = {};
  if (::ioctl(descriptor, TIOCGWINSZ, &window) == 0 && window.ws_col > 0) return window.ws_col;
  constexpr std::size_t usual = 80;
  const std::string columns = variable("COLUMNS");
  std::size_t width = 0;
  const char* end = columns.data() + columns.size();
  const auto [read_to, error] = std::from_chars(columns.data(), end, width);
  return error == std::errc{} && read_to == end && width > 0 ? width : usual;
}

}  // namespace

Terminal terminal(int descriptor) {
  Terminal result;
  // Open MPI's mpirun reads what its processes print from a terminal of its own.
  if (::isatty(descriptor) != 1 || std::getenv("OMPI_COMM_WORLD_SIZE") != nullptr) return result;
  const std::string kind = variable("TERM");
  result.is_one = true;
  result.obeys_codes = !kind.empty() && kind != "dumb";
  result.colour = result.obeys_codes && variable("NO_COLOR").empty();
  result.width = width_of(descriptor);
  return result;
}

}  // namespace reeve::cli
