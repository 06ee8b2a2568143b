#include "cli/command_line.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <optional>
#include <string_view>
#include <utility>

#include "cli/api.hpp"
#include "core/error.hpp"
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

// Returns the text behind `start` in the words; nothing if `start` does not stand there.
std::optional<std::string> behind(const std::string& words, const std::string& start) {
  const std::size_t at = words.find(start);
  if (at == std::string::npos) return std::nullopt;
  return words.substr(at + start.size());
}

std::string expectation(const std::string& words, const CLI::Option& option) {
  if (const auto range = behind(words, " not in range ")) return "a number from " + *range;
  if (const auto set = behind(words, " not in ")) return "one of " + *set;
  if (const auto said = behind(words, "expected ")) return *said;
  return fmt::format("a value of type {}", option.get_type_name());
}

// Returns the fault of "--top: Value 0 not in range 1 to 100000" and "Could not convert: --top =
// x".
InputFault option_fault(const CLI::App& command, const std::string& words) {
  InputFault fault{.where = command.get_name(), .what = words};
  for (const CLI::Option* option : command.get_options()) {
    const std::string name = option->get_name();
    const bool is_refused = words.starts_with(name + ": ") ||
                            words.starts_with(fmt::format("Could not convert: {} = ", name));
    if (!is_refused || option->count() == 0) continue;
    fault.what = name;
    fault.value = fmt::format("{}", fmt::join(option->results(), ", "));
    fault.expected = expectation(words, *option);
  }
  return fault;
}

std::string fault_of_whole_number(const std::string& text) {
  const std::string_view digits = std::string_view(text).substr(text.starts_with('-') ? 1 : 0);
  const bool is_whole =
      !digits.empty() && digits.find_first_not_of("0123456789") == std::string_view::npos;
  const bool is_fine = is_whole && (digits[0] != '0' || digits.size() == 1);
  return is_fine ? "" : fmt::format("Value '{}': expected a whole number such as 10", text);
}

}  // namespace

bool is_among(const std::vector<std::string>& names, const CLI::Option& option) {
  return std::ranges::any_of(names,
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
  const auto positionals = std::ranges::find(arguments, "--");
  for (auto argument = arguments.begin(); argument != arguments.end(); ++argument) {
    const bool has_empty_value = argument < positionals && argument->starts_with("--") &&
                                 argument->find('=') == argument->size() - 1;
    given.push_back(has_empty_value ? argument->substr(0, argument->size() - 1) : *argument);
    if (has_empty_value) given.emplace_back();
  }
  std::ranges::reverse(given);  // as CLI11 wants them
  command.parse(std::move(given));
}

void require_whole_numbers(CLI::App& program) {
  const CLI::Validator whole(fault_of_whole_number, "");
  for (CLI::App* command : program.get_subcommands({})) {
    for (CLI::Option* option : command->get_options()) {
      const std::string type = option->get_type_name();
      if (type.starts_with("INT") || type.starts_with("UINT")) option->transform(whole);
    }
  }
}

void parse_for_api(CLI::App& program, const CLI::App& command,
                   const std::vector<std::string>& arguments) {
  require_whole_numbers(program);
  std::vector<std::string> given{command.get_name()};
  given.insert(given.end(), arguments.begin(), arguments.end());
  try {
    parse(program, given);
  } catch (const CLI::ParseError& error) {
    throw api::OptionError(fmt::format("{}: {}", command.get_name(), error.what()),
                           option_fault(command, error.what()));
  }
}

}  // namespace reeve::cli
