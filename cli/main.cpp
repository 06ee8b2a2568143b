#include "cli/complaint.hpp"
#include "cli/program.hpp"

namespace {

// Also what runs before main may fail. Here and not in a library: the Python module would end its
// interpreter so.
__attribute__((constructor(101))) void prepare_for_the_worst() {
  reeve::cli::catch_termination();
  reeve::cli::outlive_full_files();
}

}  // namespace

int main(int argc, char** argv) { return reeve::cli::program(argc, argv); }
