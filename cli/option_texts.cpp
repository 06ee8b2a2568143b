#include "cli/option_texts.hpp"

#include <CLI/CLI.hpp>

#include <utility>

#include "cli/api.hpp"
#include "cli/commands/commands.hpp"
#include "core/text.hpp"

namespace reeve::cli {
namespace {

std::string kind_of(const CLI::Option& option) {
  if (option.get_expected_max() == 0) return "flag";
  if (option.get_expected_max() > 1) return "list";
  const std::string type = option.get_type_name();
  if (type.starts_with("INT") || type.starts_with("UINT")) return "int";
  return type.starts_with("FLOAT") ? "float" : "text";
}

// CLI11 tells them in the name of the type alone: "TEXT:{paper,full,all}".
std::vector<std::string> choices_of(const CLI::Option& option) {
  const std::string type = option.get_type_name();
  const std::size_t open = type.find('{');
  if (open == std::string::npos || !type.ends_with('}')) return {};
  return comma_separated(type.substr(open + 1, type.size() - open - 2));
}

OptionText text_of(const CLI::Option& option) {
  OptionText text;
  text.positional = !option.nonpositional();
  text.name = text.positional ? option.get_name() : option.get_lnames().front();
  text.preset = option.get_default_str();
  text.meaning = option.get_description();
  text.kind = kind_of(option);
  if (!option.get_snames().empty()) text.short_name = option.get_snames().front();
  text.choices = choices_of(option);
  return text;
}

}  // namespace

void add_subcommands(CLI::App& program, int& exit_code) {
  for (auto* add :
       {add_explore, add_rank, add_show, add_catalogue, add_count, add_check, add_compare,
        add_import, add_simulate, add_diagnose, add_size, add_merge, add_export}) {
    add(program, exit_code);
  }
}

std::vector<SubcommandText> subcommand_texts() {
  CLI::App program("", "reeve");
  int exit_code = done;
  add_subcommands(program, exit_code);
  std::vector<SubcommandText> texts;
  for (const CLI::App* command : program.get_subcommands({})) {
    texts.push_back({command->get_name(), command->get_description(), {}});
    for (const CLI::Option* option : command->get_options()) {
      if (option->get_name() != "--help") texts.back().options.push_back(text_of(*option));
    }
  }
  return texts;
}

std::vector<OptionText> api::option_texts(const std::string& subcommand) {
  for (SubcommandText& text : subcommand_texts()) {
    if (text.name == subcommand) return std::move(text.options);
  }
  return {};
}

}  // namespace reeve::cli
