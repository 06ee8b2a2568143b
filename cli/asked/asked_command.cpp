#include "cli/asked/asked_command.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <optional>

#include "cli/commands/commands.hpp"
#include "core/error.hpp"

namespace reeve::cli {
namespace {

OptionText text_of(const CLI::Option& option) {
  std::string name = option.nonpositional() ? option.get_lnames().front() : option.get_name();
  return {std::move(name), option.get_default_str(), option.get_description(),
          option.get_expected_max() == 0};
}

// What stands behind `start` in the words; nothing if it does not stand there.
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

// Of "--top: Value 0 not in range 1 to 100000" and "Could not convert: --top = x".
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

}  // namespace

void parse_asked(CLI::App& program, const CLI::App& command, const Arguments& arguments) {
  refuse_leading_zeros(program);
  std::vector<std::string> given{command.get_name()};
  given.insert(given.end(), arguments.begin(), arguments.end());
  try {
    parse(program, given);
  } catch (const CLI::ParseError& error) {
    throw OptionError(fmt::format("{}: {}", command.get_name(), error.what()),
                      option_fault(command, error.what()));
  }
}

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

}  // namespace reeve::cli
