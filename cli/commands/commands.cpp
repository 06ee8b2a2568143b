#include "cli/commands/commands.hpp"

namespace reeve::cli {

void add_subcommands(CLI::App& program, int& exit_code) {
  for (auto* add :
       {add_explore, add_rank, add_show, add_catalogue, add_count, add_check, add_compare,
        add_import, add_simulate, add_diagnose, add_size, add_merge, add_export}) {
    add(program, exit_code);
  }
}

}  // namespace reeve::cli
