#include "cli/unknown_words.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <optional>
#include <string_view>
#include <vector>

#include "core/nearest_name.hpp"
#include "reports/output/shell_word.hpp"

namespace reeve::cli {
namespace {

// Words that other programs use, and what they mean here; a word may have several lines.
struct CommonWord {
  std::string_view word;
  std::string_view name;
};

constexpr std::array common_words{
    CommonWord{"friction", "mu"},       CommonWord{"coefficient", "mu"},
    CommonWord{"bend", "sheath-bend"},  CommonWord{"angle", "sheath-bend"},
    CommonWord{"jobs", "threads"},      CommonWord{"cores", "threads"},
    CommonWord{"limit", "top"},         CommonWord{"filter", "constraint"},
    CommonWord{"config", "hardware"},   CommonWord{"parameters", "hardware"},
    CommonWord{"output", "out"},        CommonWord{"directory", "out"},
    CommonWord{"pulleys", "blocks"},    CommonWord{"weights", "score"},
    CommonWord{"optimize", "explore"},  CommonWord{"optimise", "explore"},
    CommonWord{"enumerate", "explore"}, CommonWord{"search", "explore"},
    CommonWord{"fit", "diagnose"},      CommonWord{"identify", "diagnose"},
    CommonWord{"validate", "check"},    CommonWord{"verify", "check"},
    CommonWord{"solve", "show"},        CommonWord{"draw", "show"},
    CommonWord{"convert", "import"},    CommonWord{"generate", "simulate"},
};

std::optional<std::string> by_meaning(const std::string& word,
                                      const std::vector<std::string>& known) {
  for (const CommonWord& common : common_words) {
    const bool is_known = std::ranges::find(known, common.name) != known.end();
    if (is_known && common.word == word) return std::string(common.name);
  }
  return std::nullopt;
}

std::optional<std::string> meant(const std::string& word, const std::vector<std::string>& known) {
  const auto common = by_meaning(word, known);
  return common ? common : core::nearest_name(word, known);
}

std::vector<std::string> option_names(const CLI::App& command) {
  std::vector<std::string> names;
  for (const CLI::Option* option : command.get_options()) {
    if (!option->nonpositional()) continue;
    names.insert(names.end(), option->get_lnames().begin(), option->get_lnames().end());
  }
  return names;
}

std::vector<std::string> subcommand_names(const CLI::App& program) {
  std::vector<std::string> names;
  for (const CLI::App* command : program.get_subcommands({})) names.push_back(command->get_name());
  return names;
}

// Returns "fingerz" for "--fingerz=3", and nothing for a value, such as "-1".
std::optional<std::string> option_name(const std::string& word) {
  if (!word.starts_with('-')) return std::nullopt;
  const std::size_t begin = word.find_first_not_of('-');
  if (begin == std::string::npos) return std::nullopt;
  return word.substr(begin, word.find('=') - begin);
}

struct Suggestion {
  std::string typed;
  std::string known;
};

std::vector<Suggestion> suggestions(const CLI::App& command,
                                    const std::vector<std::string>& words) {
  std::vector<Suggestion> found;
  const std::vector<std::string> known = option_names(command);
  for (const std::string& word : words) {
    const auto name = option_name(word);
    const auto near = name ? meant(*name, known) : std::nullopt;
    if (near) found.push_back({word.substr(0, word.find('=')), "--" + *near});
  }
  return found;
}

// A single suggestion does not repeat the typed word.
std::string question(const std::vector<Suggestion>& found) {
  if (found.empty()) return "";
  if (found.size() == 1) return fmt::format("; did you mean {}?", found.front().known);
  std::string text = "; did you mean ";
  for (const Suggestion& suggestion : found) {
    text += fmt::format("{}{} for {}", &suggestion == &found.front() ? "" : ", ", suggestion.known,
                        suggestion.typed);
  }
  return text + "?";
}

std::string listed(const std::vector<std::string>& words) {
  std::string text;
  for (const std::string& word : words) text += " " + shell_word(word);
  return text;
}

// "reeve --fingers 3 explore" has the option before its subcommand.
const CLI::App* owner(const CLI::App& program, const std::string& option) {
  for (const CLI::App* command : program.get_subcommands()) {
    const std::vector<std::string> names = option_names(*command);
    if (std::ranges::find(names, option) != names.end()) return command;
  }
  return nullptr;
}

std::string unknown_of_program(const CLI::App& program, const std::vector<std::string>& words) {
  const std::string& first = words.front();
  const auto option = option_name(first);
  if (!option) {
    const auto near = meant(first, subcommand_names(program));
    return fmt::format("unknown subcommand {}{}", shell_word(first),
                       near ? fmt::format("; did you mean {}?", *near) : "");
  }
  if (const CLI::App* command = owner(program, *option)) {
    return fmt::format("{} before the subcommand; expected reeve {} {}", shell_word(first),
                       command->get_name(), shell_word(first));
  }
  return "unexpected" + listed(words) + question(suggestions(program, words));
}

}  // namespace

std::string help_command(const CLI::App& program) {
  const std::vector<CLI::App*> given = program.get_subcommands();
  return given.empty() ? "reeve --help" : fmt::format("reeve {} --help", given.front()->get_name());
}

std::string pointed_to_help(const std::string& complaint, const CLI::App& program) {
  return fmt::format("{}{} {}", complaint, complaint.ends_with('?') ? " See" : "; see",
                     help_command(program));
}

std::string unknown_words(const CLI::App& program) {
  const std::vector<std::string> of_program = program.remaining();
  if (!of_program.empty()) {
    return pointed_to_help(unknown_of_program(program, of_program), program);
  }
  for (const CLI::App* command : program.get_subcommands()) {
    const std::vector<std::string> words = command->remaining();
    if (words.empty()) continue;
    return pointed_to_help(fmt::format("{}: unexpected{}{}", command->get_name(), listed(words),
                                       question(suggestions(*command, words))),
                           program);
  }
  return "";
}

}  // namespace reeve::cli
