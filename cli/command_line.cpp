#include "cli/command_line.hpp"

#include <algorithm>
#include <utility>

#include "reports/output/shell_word.hpp"

namespace reeve::cli {
namespace {

// A value that begins with '-' would pass for an option.
std::string option_text(const CLI::Option& option) {
  const std::string name = option.get_name();
  if (option.get_expected_max() == 0) return " " + name;
  std::string text;
  for (const std::string& value : option.results()) {
    text += " " + name + (value.starts_with('-') ? "=" : " ") + shell_word(value);
  }
  return text;
}

template <typename Wanted>
std::string options_text(const CLI::App& command, Wanted wanted) {
  std::string text;
  for (const CLI::Option* option : command.get_options()) {
    if (option->count() > 0 && option->nonpositional() && wanted(*option)) {
      text += option_text(*option);
    }
  }
  return text;
}

// Behind an option that takes any number of values they would be among these.
std::string positionals_text(const CLI::App& command) {
  std::string text;
  for (const CLI::Option* option : command.get_options()) {
    if (option->nonpositional()) continue;
    for (const std::string& value : option->results()) text += " " + shell_word(value);
  }
  return text;
}

}  // namespace

bool is_among(const std::vector<std::string>& names, const CLI::Option& option) {
  return std::any_of(names.begin(), names.end(),
                     [&](const std::string& name) { return option.check_name(name); });
}

std::string command_line(const CLI::App& command, const std::vector<std::string>& left_out) {
  return "reeve " + command.get_name() + positionals_text(command) +
         options_text(command,
                      [&](const CLI::Option& option) { return !is_among(left_out, option); });
}

std::string given_options(const CLI::App& command, const std::vector<std::string>& wanted) {
  return options_text(command, [&](const CLI::Option& option) { return is_among(wanted, option); });
}

std::vector<std::string> given_arguments(const CLI::App& command,
                                         const std::vector<std::string>& left_out) {
  std::vector<std::string> arguments;
  for (const CLI::Option* option : command.get_options()) {
    if (option->count() == 0 || !option->nonpositional() || is_among(left_out, *option)) continue;
    if (option->get_expected_max() == 0) {
      arguments.push_back(option->get_name());
      continue;
    }
    for (const std::string& value : option->results()) {
      arguments.push_back(option->get_name() + "=" + value);
    }
  }
  return arguments;
}

void parse(CLI::App& command, const std::vector<std::string>& arguments) {
  std::vector<std::string> given;
  const auto positionals = std::find(arguments.begin(), arguments.end(), "--");
  for (auto argument = arguments.begin(); argument != arguments.end(); ++argument) {
    const bool has_empty_value = argument < positionals && argument->starts_with("--") &&
                                 argument->find('=') == argument->size() - 1;
    given.push_back(has_empty_value ? argument->substr(0, argument->size() - 1) : *argument);
    if (has_empty_value) given.emplace_back();
  }
  std::reverse(given.begin(), given.end());  // as CLI11 wants them
  command.parse(std::move(given));
}

void refuse_leading_zeros(CLI::App& program) {
  const CLI::Validator decimal(
      [](const std::string& text) {
        const std::size_t begin = text.find_first_not_of("+-");
        const bool is_fine = begin == std::string::npos || text[begin] != '0' ||
                             text.find_first_not_of('0', begin) == std::string::npos;
        return is_fine ? std::string()
                       : "Value " + text + " begins with 0: expected a whole number such as 10";
      },
      "");
  for (CLI::App* command : program.get_subcommands({})) {
    for (CLI::Option* option : command->get_options()) {
      const std::string type = option->get_type_name();
      if (type.starts_with("INT") || type.starts_with("UINT")) option->transform(decimal);
    }
  }
}

}  // namespace reeve::cli
