#include "reports/exploration/drawn_columns.hpp"

#include <fmt/format.h>

#include <optional>

#include "core/text.hpp"
#include "reports/exploration/decision_words.hpp"

namespace reeve::reports {
namespace {

DrawnColumn named_column(const std::string& key, const std::string& heading,
                         const std::string& unit,
                         std::function<std::string(const ListedDesign&)> cell) {
  DrawnColumn made{number_column(heading, unit), std::move(cell)};
  made.column.key = key;
  return made;
}

DrawnColumn place_column(const std::string& key, const std::string& heading,
                         double RankDistribution::*part, bool is_share) {
  return named_column(key, heading, "",
                      [part, is_share](const ListedDesign& design) -> std::string {
                        if (!design.distribution) return "-";
                        const double number = (*design.distribution).*part;
                        return is_share ? share_text(number) : fixed(number, 0);
                      });
}

DrawnColumn band_column(const ObjectiveRow& row, const std::string& key, const std::string& heading,
                        double Band::*part) {
  const std::string whose =
      *row.part == '\0' ? row.heading : std::string(row.heading) + ", " + row.part;
  const auto cell = [&row, part](const ListedDesign& design) -> std::string {
    const Band* band = find_band(design.bands, row.objective);
    return band == nullptr ? "-" : fixed((*band).*part, row.decimals);
  };
  return named_column(std::string(row.name) + "_" + key, whose + ", " + heading,
                      objective_unit(row.objective), cell);
}

}  // namespace

std::vector<DrawnColumn> drawn_columns(bool with_hand, bool with_constraints) {
  std::vector<DrawnColumn> columns{
      place_column("first_share", "first", &RankDistribution::first, true),
      place_column("first_shared", "first, shared", &RankDistribution::first_shared, true),
      place_column("rank_median", "median place", &RankDistribution::median, false),
      place_column("rank_p5", "place, 5 %", &RankDistribution::low, false),
      place_column("rank_p95", "place, 95 %", &RankDistribution::high, false)};
  if (with_constraints) {
    columns.push_back(
        named_column("constraints_met", "meets all", "", [](const ListedDesign& design) {
          return design.constraints_met ? share_text(*design.constraints_met) : std::string("-");
        }));
  }
  for (const Objective objective : friction_objectives(with_hand)) {
    const ObjectiveRow& about = row(objective);
    columns.push_back(band_column(about, "median", "median", &Band::median));
    columns.push_back(band_column(about, "p5", "5 %", &Band::low));
    columns.push_back(band_column(about, "p95", "95 %", &Band::high));
  }
  return columns;
}

}  // namespace reeve::reports
