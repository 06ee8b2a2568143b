#include "cli/api.hpp"

#include <CLI/CLI.hpp>

#include "cli/commands/commands.hpp"

namespace reeve::cli::api {
namespace {

std::string kind_of(const CLI::Option& option) {
  if (option.get_expected_max() == 0) return "flag";
  if (option.get_expected_max() > 1) return "list";
  const std::string type = option.get_type_name();
  if (type.starts_with("INT") || type.starts_with("UINT")) return "int";
  return type.starts_with("FLOAT") ? "float" : "text";
}

OptionText text_of(const CLI::Option& option) {
  std::string name = option.nonpositional() ? option.get_lnames().front() : option.get_name();
  return {std::move(name), option.get_default_str(), option.get_description(), kind_of(option)};
}

}  // namespace

std::vector<OptionText> option_texts(const std::string& subcommand) {
  CLI::App program("", "reeve");
  int exit_code = done;
  for (auto* add : {add_explore, add_rank, add_size, add_diagnose, add_show, add_count, add_check,
                    add_compare, add_simulate, add_import, add_merge}) {
    add(program, exit_code);
  }
  std::vector<OptionText> texts;
  for (const CLI::App* command : program.get_subcommands({})) {
    if (command->get_name() != subcommand) continue;
    for (const CLI::Option* option : command->get_options()) {
      if (option->get_name() != "--help") texts.push_back(text_of(*option));
    }
  }
  return texts;
}

}  // namespace reeve::cli::api
