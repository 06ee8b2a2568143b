#include "cli/manual.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <array>
#include <map>
#include <string_view>

namespace reeve::cli {
namespace {

// Text that roff takes as it stands: a minus stays one, and no line begins a request.
std::string roff(std::string_view text) {
  std::string result;
  bool at_line_begin = true;
  for (const char c : text) {
    if (at_line_begin && (c == '.' || c == '\'')) result += "\\&";
    if (c == '\\') {
      result += "\\e";
    } else if (c == '-') {
      result += "\\-";
    } else {
      result += c;
    }
    at_line_begin = c == '\n';
  }
  return result;
}

std::string value_name(const OptionText& option) {
  if (!option.choices.empty()) return fmt::format("{}", fmt::join(option.choices, "|"));
  if (option.kind == "int") return "N";
  return option.kind == "float" ? "NUMBER" : "VALUE";
}

std::string option_head(const OptionText& option) {
  if (option.positional) return fmt::format(".I {}", roff(option.name));
  const std::string short_name =
      option.short_name.empty() ? "" : fmt::format("\\fB\\-{}\\fR, ", option.short_name);
  std::string head = fmt::format("{}\\fB{}\\fR", short_name, roff("--" + option.name));
  if (option.kind != "flag") head += fmt::format(" \\fI{}\\fR", roff(value_name(option)));
  return head;
}

std::string option_entry(const OptionText& option) {
  std::string text = fmt::format(".TP\n{}\n{}", option_head(option), roff(option.meaning));
  if (!option.meaning.ends_with('.')) text += '.';
  if (!option.preset.empty()) text += fmt::format(" Default: {}.", roff(option.preset));
  return text + '\n';
}

std::string subcommand_section(const SubcommandText& subcommand) {
  std::string text = fmt::format(".SS reeve {}\n{}.\n", subcommand.name, roff(subcommand.meaning));
  for (const OptionText& option : subcommand.options) text += option_entry(option);
  return text;
}

constexpr std::string_view manual_description =
    "reeve explores, ranks and checks tendon routings: the ways in which one motor's tendon can be "
    "led through the fingers of a soft wearable hand. A routing is written as the walk of its "
    "tendon, such as M-1-T-2-F or 1-P-2-P-1; names of the catalogue, such as TR7, can stand in its "
    "place.";

struct Variable {
  std::string_view name;
  std::string_view meaning;
};

constexpr std::array environment{
    Variable{"REEVE_CATALOG", "Folder of a catalogue in place of the one in the program."},
    Variable{"REEVE_MPI", "off: each process that mpirun starts works on its own."},
    Variable{"NO_COLOR", "Any value: no colour on the terminal; so does TERM=dumb."}};

constexpr std::string_view exit_codes = R"(.SH EXIT STATUS
.TP
.B 0
Done.
.TP
.B 1
The answer is no: a check failed, a log holds no reading, no design meets the constraints.
.TP
.B 2
Bad usage or input; one line on standard error names it.
.TP
.B 3
Interrupted, standard output cannot be written, not enough memory, or an internal error.
)";

constexpr std::string_view copyright = R"(.SH COPYRIGHT
Copyright 2026 the reeve authors. MIT licence; there is no warranty.
)";

std::string option_line(const OptionText& option) {
  std::string head = option.positional ? option.name : "--" + option.name;
  if (!option.short_name.empty()) head = fmt::format("-{}, {}", option.short_name, head);
  if (!option.positional && option.kind != "flag") head += '=' + value_name(option);
  const std::string preset = option.preset.empty() ? "" : fmt::format(" ({})", option.preset);
  return fmt::format("{:<24}  {}{}\n", head, option.meaning, preset);
}

// Each option once, below a heading with the subcommands that take it with this text.
std::string option_sections(const std::vector<SubcommandText>& subcommands) {
  std::vector<std::string> lines;
  std::map<std::string, std::string> takers;
  for (const SubcommandText& subcommand : subcommands) {
    for (const OptionText& option : subcommand.options) {
      const std::string line = option_line(option);
      std::string& names = takers[line];
      if (names.empty()) lines.push_back(line);
      names += (names.empty() ? "" : ", ") + subcommand.name;
    }
  }
  std::vector<std::string> headings;
  std::map<std::string, std::string> sections;
  for (const std::string& line : lines) {
    std::string& section = sections[takers[line]];
    if (section.empty()) headings.push_back(takers[line]);
    section += line;
  }
  std::string text;
  for (const std::string& heading : headings) {
    text += fmt::format("\n## {}\n\n```text\n{}```\n", heading, sections[heading]);
  }
  return text;
}

std::vector<std::string> words_of_options(const SubcommandText& subcommand) {
  std::vector<std::string> words{"--help"};
  for (const OptionText& option : subcommand.options) {
    if (!option.positional) words.push_back("--" + option.name);
  }
  return words;
}

std::string choices_cases(const SubcommandText& subcommand) {
  std::string cases;
  for (const OptionText& option : subcommand.options) {
    if (option.positional || option.choices.empty()) continue;
    cases += fmt::format("    {},--{}) values=\"{}\" ;;\n", subcommand.name, option.name,
                         fmt::join(option.choices, " "));
  }
  return cases;
}

}  // namespace

std::string man_page(const std::vector<SubcommandText>& subcommands, const std::string& version) {
  std::string text = fmt::format(
      ".TH REEVE 1 \"\" \"reeve {}\" \"User Commands\"\n.SH NAME\nreeve \\- explore, rank and "
      "diagnose tendon routings\n.SH SYNOPSIS\n.B reeve\n.I SUBCOMMAND\n.RI [ OPTION ]...\n.br\n"
      ".B reeve\n.I SUBCOMMAND\n.B \\-\\-help\n.SH DESCRIPTION\n{}\n.SH SUBCOMMANDS\n",
      version, roff(manual_description));
  for (const SubcommandText& subcommand : subcommands) text += subcommand_section(subcommand);
  text += exit_codes;
  text += ".SH ENVIRONMENT\n";
  for (const Variable& one : environment) {
    text += fmt::format(".TP\n.B {}\n{}\n", one.name, roff(one.meaning));
  }
  return text + std::string(copyright);
}

std::string options_document(const std::vector<SubcommandText>& subcommands) {
  std::string text =
      "# Options\n\n*`reeve_write_manual --options` writes this page from the program's table of "
      "options. Defaults are in brackets. `reeve --help` lists the subcommands.*\n" +
      option_sections(subcommands) + "\n## Environment\n\n```text\n";
  for (const Variable& one : environment) {
    text += fmt::format("{:<13}  {}\n", one.name, one.meaning);
  }
  return text + "```\n";
}

std::string bash_completion(const std::vector<SubcommandText>& subcommands) {
  std::vector<std::string> names{"--help", "--version"};
  std::string options;
  std::string choices;
  for (const SubcommandText& subcommand : subcommands) {
    names.push_back(subcommand.name);
    options += fmt::format("    {}) words=\"{}\" ;;\n", subcommand.name,
                           fmt::join(words_of_options(subcommand), " "));
    choices += choices_cases(subcommand);
  }
  return fmt::format(
      R"(# Completion of reeve for bash, made of the program's options when it was built.
_reeve() {{
  local word=${{COMP_WORDS[COMP_CWORD]}} before=${{COMP_WORDS[COMP_CWORD - 1]}} words="" values=""
  if ((COMP_CWORD == 1)); then
    COMPREPLY=($(compgen -W "{}" -- "$word"))
    return
  fi
  case "${{COMP_WORDS[1]}},$before" in
{}  esac
  if [[ -n $values ]]; then
    COMPREPLY=($(compgen -W "$values" -- "$word"))
    return
  fi
  [[ $word == -* ]] || return
  case "${{COMP_WORDS[1]}}" in
{}  esac
  COMPREPLY=($(compgen -W "$words" -- "$word"))
}}
complete -o default -F _reeve reeve
)",
      fmt::join(names, " "), choices, options);
}

}  // namespace reeve::cli
