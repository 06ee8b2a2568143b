#include "reports/exploration/stored_ranking_report.hpp"

#include <fmt/format.h>

#include <array>
#include <vector>

#include "reports/exploration/decision_words.hpp"
#include "reports/exploration/design_list.hpp"
#include "reports/exploration/explore_report.hpp"
#include "reports/exploration/tradeoff_report.hpp"
#include "reports/model_text.hpp"
#include "reports/output/json.hpp"
#include "search/evaluate/shown_objectives.hpp"

namespace reeve::reports {
namespace {

constexpr std::size_t most_lines = 10;

std::string gap_text(Gap gap) {
  // In the order of Gap.
  constexpr std::array names{
      "other objectives, or another score that decides, than the store was made with",
      "a constraint of the store is not asked for, and what it left out was not kept",
      "a further constraint on what is not ranked by, or on its better side",
      "more designs than the store keeps"};
  return names.at(static_cast<std::size_t>(gap));
}

std::vector<std::string> gap_texts(const StoredRanking& ranking) {
  std::vector<std::string> texts;
  for (const Gap gap : ranking.gaps) texts.push_back(gap_text(gap));
  return texts;
}

std::string inexact_note(const StoredRanking& ranking) {
  if (ranking.gaps.empty()) return "";
  return fmt::format(
      "not exact: {}. These are the best of what was kept; designs that were not may belong before "
      "or among them. An exploration with --keep all, or with these settings, has all",
      fmt::join(gap_texts(ranking), "; "));
}

std::string partial_text(const StoredRanking& ranking) {
  if (!ranking.partial) return "";
  const ExploreResult& result = ranking.report.result;
  return fmt::format("{} of {} routings of {} of {} shards were generated so far", result.generated,
                     result.total, ranking.shards, ranking.of_shards);
}

std::vector<DocumentLine> opening(const StoredRanking& ranking) {
  const ExploreResult& result = ranking.report.result;
  std::vector<DocumentLine> lines{
      {fmt::format("{} designs kept of {} evaluated, {} of them do not meet the constraints",
                   ranking.kept, result.evaluated, ranking.failed)}};
  if (ranking.partial) lines.push_back({"PARTIAL: " + partial_text(ranking), true});
  const std::string note = inexact_note(ranking);
  if (!note.empty()) lines.push_back({"Note: " + note, true});
  append(lines, note_lines(notes(ranking.report)));
  lines.push_back({order_text(ranking.report.options.order, ranking.report.options.score)});
  return lines;
}

}  // namespace

Document stored_ranking_document(const StoredRanking& ranking, const ListColumns& columns) {
  const ExploreReport& report = ranking.report;
  std::vector<ListedDesign> lines = one_of_each(report.top);
  if (lines.size() > most_lines) lines.resize(most_lines);
  Document document{{{"", std::nullopt, opening(ranking)}}};
  if (lines.empty()) {
    document.add({"", std::nullopt, {{"No design that was kept meets the constraints"}}});
    return document;
  }
  document.add({"", std::nullopt, answer_lines(report.top, report.tradeoff)});
  const ExploreOptions& options = report.options;
  document.add(
      {fmt::format("Top {}", lines.size()),
       design_table(lines, shown_objectives(options.order, options.score, options.constraints),
                    priced(columns, options.prices)),
       list_notes(lines)});
  if (columns.chosen.empty()) document.add(tradeoff_section(report.tradeoff));
  return document;
}

std::string stored_ranking_json(const StoredRanking& ranking) {
  const ExploreResult& result = ranking.report.result;
  Json json{{"exact", ranking.gaps.empty()},
            {"inexact_because", gap_texts(ranking)},
            {"partial", ranking.partial},
            {"notes", notes(ranking.report)},
            {"total", result.total},
            {"generated", result.generated},
            {"evaluated", result.evaluated},
            {"kept", ranking.kept},
            {"failed_constraints", ranking.failed},
            {"front_equals_left_out", result.front_equals_left_out}};
  json["front"] = to_json(ranking.report.front);
  json["top"] = to_json(ranking.report.top);
  json["tradeoff"] = tradeoff_json(ranking.report.tradeoff);
  json["never_jams"] = never_jams_json(ranking.report.tradeoff);
  json["settings"] = explore_settings(ranking.report);
  json["version"] = version_json();
  return print(json);
}

std::string stored_ranking_csv(const StoredRanking& ranking) {
  std::string note = partial_text(ranking);
  if (!note.empty()) note = "partial: " + note;
  const std::string inexact = inexact_note(ranking);
  if (!inexact.empty()) note += (note.empty() ? "" : "; ") + inexact;
  return design_csv(ranking.report.top, note);
}

}  // namespace reeve::reports
