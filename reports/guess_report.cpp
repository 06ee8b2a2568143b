#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "readings/columns.hpp"
#include "readings/fault_list.hpp"
#include "reports/data_text.hpp"
#include "reports/import_report.hpp"
#include "reports/output/json.hpp"

namespace reeve::reports {
namespace {

constexpr std::size_t shown_samples = 5;

const char* kind_name(GuessKind kind) {
  // In the order of GuessKind.
  constexpr std::array names{"known", "guessed", "unknown"};
  return names.at(static_cast<std::size_t>(kind));
}

const char* separator_name(char separator) {
  if (separator == ';') return "semicolons";
  return separator == '\t' ? "tabs" : "commas";
}

std::string first_cell(const LogGuess& guess, std::size_t column) {
  return guess.first_rows.empty() ? "" : guess.first_rows.front()[column];
}

Section columns_section(const GuessReport& report) {
  Table table{{text_column("column"), text_column("read as"), text_column("first cell"),
               text_column("note")},
              {}};
  const LogGuess& guess = report.guess;
  for (std::size_t i = 0; i < guess.columns.size(); ++i) {
    const GuessedColumn& column = guess.columns[i];
    const bool is_unknown = column.kind == GuessKind::unknown;
    table.add({column.name, is_unknown ? "covariate" : column.meaning, first_cell(guess, i),
               column.reason.empty() ? kind_name(column.kind) : column.reason});
  }
  return {"Columns", table, {}};
}

std::vector<const LoggedSignal*> signals_of(const LoggedSeries& series) {
  std::vector<const LoggedSignal*> signals;
  for (const LoggedSignal* signal : {&series.position_mm, &series.speed_mm_s}) {
    if (signal->is_logged()) signals.push_back(signal);
  }
  for (const LoggedSignal* signal : series.sensors()) signals.push_back(signal);
  for (const LoggedSignal& other : series.others) signals.push_back(&other);
  return signals;
}

std::string sample_cell(double value) {
  return std::isnan(value) ? "-" : fmt::format("{:.6g}", value);
}

// The rows are in reeve's units, as far as the log could be read.
Section rows_section(const LoggedSeries& series) {
  const std::vector<const LoggedSignal*> signals = signals_of(series);
  Table table{{number_column("time_s")}, {}};
  for (const LoggedSignal* signal : signals) table.columns.push_back(number_column(signal->name));
  for (std::size_t i = 0; i < std::min(series.size(), shown_samples); ++i) {
    std::vector<std::string> cells{sample_cell(series.time_s[i])};
    for (const LoggedSignal* signal : signals) cells.push_back(sample_cell(signal->values[i]));
    table.add(std::move(cells));
  }
  return {fmt::format("First samples as understood, of {}", series.size()), table, {}};
}

// Faults of several rows that differ in place and value alone are told once.
std::vector<std::string> fault_words(const std::vector<InputFault>& faults) {
  const auto is_equal = [](const InputFault& a, const InputFault& b) {
    return a.what == b.what && a.expected == b.expected;
  };
  std::vector<std::string> words;
  for (auto fault = faults.begin(); fault != faults.end(); ++fault) {
    const auto same = [&](const InputFault& other) { return is_equal(*fault, other); };
    if (std::any_of(faults.begin(), fault, same)) continue;
    const auto further = static_cast<std::size_t>(std::count_if(fault + 1, faults.end(), same));
    // The reader lists so many at most.
    const char* or_more = faults.size() < most_listed_faults ? "" : " or more";
    words.push_back(sentence(*fault));
    if (further == 0) continue;
    words.back() +=
        fmt::format(" (and {}{} further row{})", further, or_more, further == 1 ? "" : "s");
  }
  return words;
}

std::vector<std::string> problem_words(const GuessReport& report) {
  std::vector<std::string> words = fault_words(report.faults);
  if (report.lacks_routing) {
    words.push_back(
        "the routing: --routing with a name of the catalogue or a word such as "
        "M-1-T-2-F, or a column routing");
  }
  return words;
}

std::vector<std::string> assumed_words(const GuessReport& report) {
  std::vector<std::string> words;
  if (!report.guess.titles.empty()) words.push_back(titles_text(report.guess.titles));
  if (report.lacks_run) words.push_back("all samples are of run 1 (--run)");
  if (report.lacks_held) words.push_back("no finger is held (--held)");
  if (report.lacks_motion) {
    words.push_back(
        "neither position nor speed is logged: levels at rest are taken, and "
        "--direction may have to say whether they pull");
  }
  if (report.lacks_motor_tension) {
    words.push_back("no motor tension is logged: shares of the tensions alone can be compared");
  }
  return words;
}

Section list_section(const std::string& title, const std::vector<std::string>& words) {
  if (words.empty()) return {};
  Section section{title, std::nullopt, {}};
  for (const std::string& line : words) section.lines.push_back({"- " + line});
  return section;
}

Json column_json(const GuessedColumn& column) {
  return {{"name", column.name},
          {"kind", kind_name(column.kind)},
          {"meaning", text_or_null(column.meaning)},
          {"reason", text_or_null(column.reason)}};
}

}  // namespace

Document guess_document(const GuessReport& report, const std::string& command) {
  Section opening;
  opening.lines.push_back({fmt::format("{}: {} separated by {}", report.file,
                                       plural(report.guess.columns.size(), "column"),
                                       separator_name(report.guess.separator))});
  Document document{{opening}};
  document.add(columns_section(report));
  if (report.series) document.add(rows_section(*report.series));
  document.add(list_section("Problems", problem_words(report)));
  document.add(list_section("Assumed", assumed_words(report)));
  if (report.can_be_read()) {
    const char* const how =
        report.lacks_routing ? "Import it, with a routing for ROUTING, by" : "Import it with";
    document.add({how, std::nullopt, {{command}}});
  }
  return document;
}

std::string guess_json(const GuessReport& report, const std::string& command) {
  Json json{{"file", report.file}, {"separator", std::string(1, report.guess.separator)}};
  json["columns"] = list_json(report.guess.columns, column_json);
  json["first_rows"] = report.guess.first_rows;
  json["missing"] = problem_words(report);
  json["assumed"] = assumed_words(report);
  json["can_be_imported"] = report.can_be_imported();
  json["command"] = report.can_be_read() ? Json(command) : Json(nullptr);
  json["version"] = version_json();
  return print(json);
}

}  // namespace reeve::reports
