#include "reports/exploration/band_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "core/text.hpp"
#include "reports/exploration/decision_words.hpp"
#include "reports/output/csv_field.hpp"
#include "reports/shown_value.hpp"
#include "search/uncertainty/coefficient_box.hpp"
#include "search/uncertainty/sweep.hpp"

namespace reeve::reports {
namespace {

constexpr std::size_t sharers_named = 4;

std::string place_range(const RankDistribution& ranks) {
  return fixed(ranks.low, 0) + "–" + fixed(ranks.high, 0);
}

// Names the first shown design that meets the constraints in nearly all draws, unless it is the
// best.
std::string surest_text(const std::vector<ListedDesign>& shown) {
  constexpr double nearly_all = 0.95;
  const auto sure = std::ranges::find_if(shown, [](const ListedDesign& design) {
    return design.constraints_met.value_or(0) >= nearly_all;
  });
  if (sure == shown.begin()) return "";
  const std::string start =
      fmt::format("{} meets all of them in {} of the draws; ", short_name(shown.front()),
                  share_text(*shown.front().constraints_met));
  if (sure == shown.end()) {
    return start + fmt::format("none of those shown does in {} or more", percent(nearly_all));
  }
  return start + fmt::format("the first that does in {} or more is {}, rank {}",
                             percent(nearly_all), short_name(*sure), sure->ranked.rank);
}

std::vector<DocumentLine> met_lines(const std::vector<ListedDesign>& shown) {
  if (shown.empty() || !shown.front().constraints_met) return {};
  std::vector<DocumentLine> lines{
      {"Meets all: in how many of the draws a design meets all constraints; which designs are "
       "listed, the nominal coefficients decide"}};
  if (std::string text = surest_text(shown); !text.empty()) lines.push_back({std::move(text)});
  return lines;
}

std::string band_cell(const ListedDesign& design, Objective objective) {
  const Band* band = find_band(design.bands, objective);
  if (band == nullptr) return shown_value(objective, value(design.ranked.design.values, objective));
  return band_text(*band, row(objective).decimals);
}

// Returns the loss relative to the other value; 0 if that is 0.
double loss_against(double own, double other) {
  return own == other || other == 0 ? 0 : (other - own) / std::abs(other);
}

// Returns the loss of the nominal best in the 5 % quantile.
double nominal_loss(const RobustFirst& first) {
  return loss_against(first.nominal.p5, first.robust.p5);
}

// Returns the loss of the most robust design at the nominal coefficients.
double robust_loss(const RobustFirst& first) {
  return loss_against(first.robust.value, first.nominal.value);
}

std::string measure_words(const RobustFirst& first) {
  if (first.by_score) return "5 % quantile of the score";
  return first.over_draws ? "5 % quantile of uniformity x efficiency"
                          : "product of the 5 % quantiles of uniformity and efficiency";
}

const char* over_words(const RobustFirst& first) {
  return first.over_draws ? "over the draws" : "if friction differs between contacts";
}

bool is_same(const RobustFirst& first) {
  return first.nominal.design.ranked.design.word == first.robust.design.ranked.design.word;
}

Json robust_design_json(const RobustDesign& robust, double loss) {
  return {{"routing", robust.design.ranked.design.word},
          {"name", text_or_null(robust.design.name)},
          {"rank", robust.design.ranked.rank},
          {"value", number(robust.value)},
          {"p5", number(robust.p5)},
          {"loss", number(loss)}};
}

}  // namespace

std::string range_text(const Band& band, int decimals) {
  const std::string low = fixed(band.low, decimals);
  const std::string high = fixed(band.high, decimals);
  if (low == high) return "";
  if (!std::isfinite(band.high)) return low + " or more";
  return low + (band.low < 0 ? " to " : "–") + high;
}

std::string band_text(const Band& band, int decimals) {
  std::string median = fixed(band.median, decimals);
  const std::string range = range_text(band, decimals);
  return range.empty() ? median : fmt::format("{} ({})", median, range);
}

std::string first_share_text(const RankDistribution& ranks) {
  std::string text = share_text(ranks.first);
  if (ranks.first_shared == 0) return text;
  if (ranks.first_shared == ranks.first) return text + ", shared";
  return fmt::format("{}, {} shared", text, share_text(ranks.first_shared));
}

Table band_table(const std::vector<ListedDesign>& designs,
                 const std::vector<Objective>& objectives) {
  Table table{{number_column("rank"), text_column("name"), text_column("routing")}, {}};
  for (const Objective objective : objectives) {
    table.columns.push_back(number_column(objective_heading(objective), objective_unit(objective)));
  }
  const bool constrained = !designs.empty() && designs.front().constraints_met.has_value();
  if (constrained) table.columns.push_back(number_column("meets all"));
  table.columns.push_back(number_column("first", "", 1));
  table.columns.push_back(number_column("median place", "", 2));
  table.columns.push_back(number_column("5–95 %", "", 2));
  for (const ListedDesign& design : designs) {
    std::vector<std::string> cells{std::to_string(design.ranked.rank),
                                   design.name.empty() ? "-" : design.name,
                                   design.ranked.design.word};
    for (const Objective objective : objectives) cells.push_back(band_cell(design, objective));
    if (constrained) {
      cells.push_back(design.constraints_met ? share_text(*design.constraints_met) : "");
    }
    if (design.distribution) {
      cells.push_back(first_share_text(*design.distribution));
      cells.push_back(fixed(design.distribution->median, 0));
      cells.push_back(place_range(*design.distribution));
    }
    cells.resize(table.columns.size());
    table.add(std::move(cells));
  }
  return table;
}

std::string mu_text(const Interval& mu) {
  return mu.low == mu.high ? fmt::format("{:.4g}", mu.low)
                           : fmt::format("{:.4g} to {:.4g}", mu.low, mu.high);
}

bool is_drawn(ContactKind kind, const Hardware& hardware,
              const std::vector<ListedDesign>& designs) {
  ValueUse use(hardware, {kind}, LawValue::mu);
  looks_at_designs(designs)(use);
  return !use.is_idle();
}

// "tubes mu 0.05 to 0.2, sheaths mu 0.05 to 0.2, bearings mu ± 50 %, bends ± 20 %, each contact
// ± 4 % (bearings 10 %)"
std::string drawn_text(const UncertaintyOptions& options,
                       const std::vector<ListedDesign>& designs) {
  const auto draws = [&](ContactKind kind) {
    return is_drawn(kind, options.nominal.hardware, designs);
  };
  const bool tubes = draws(ContactKind::tube);
  const bool sheaths = draws(ContactKind::sheath);
  const UncertaintyRanges& ranges = options.ranges;
  const CoefficientBox box = coefficient_box(options.nominal.hardware, ranges);
  const ContactScatter& scatter = options.nominal.hardware.scatter;
  const std::string bearings = options.nominal.hardware.bearing.known
                                   ? fmt::format("{:.4g}", options.nominal.hardware.bearing.mu)
                                   : fmt::format("± {:.4g} %", 100 * ranges.bearing_mu_relative);
  std::string text;
  if (tubes) text += fmt::format("tubes mu {}, ", mu_text(box[0]));
  if (sheaths) text += fmt::format("sheaths mu {}, ", mu_text(box[1]));
  text += fmt::format("bearings mu {}, bends ± {:.4g} %, ", bearings,
                      100 * ranges.sheath_angle_relative);
  const double of_bearings = 100 * scatter.bearing_relative;
  if (!tubes && !sheaths) return text + fmt::format("each bearing ± {:.4g} %", of_bearings);
  return text + fmt::format("each contact ± {:.4g} % (bearings {:.4g} %)", 100 * scatter.relative,
                            of_bearings);
}

Section band_section(const std::vector<ListedDesign>& shown, const Order& order,
                     const UncertaintyOptions& options) {
  if (shown.empty() || !shown.front().distribution) return {};
  return {
      fmt::format("Median (5–95 %) over {} draws: {}", options.draws, drawn_text(options, shown)),
      band_table(shown, swept_objectives(order)), met_lines(shown)};
}

std::vector<DocumentLine> shared_first_lines(const std::vector<ListedDesign>& designs) {
  std::vector<std::string> names, words;
  bool only_equivalent = true;
  for (const ListedDesign& design : designs) {
    if (design.place != 1) continue;
    const std::string& first = designs.front().ranked.design.word;
    only_equivalent =
        only_equivalent && (design.ranked.design.word == first || design.same_as == first);
    names.push_back(short_name(design));
    words.push_back(design.ranked.design.word);
  }
  // Several words may be of one known routing.
  if (std::set<std::string>(names.begin(), names.end()).size() < names.size()) names = words;
  const bool drawn = !designs.empty() && designs.front().distribution.has_value();
  if (names.size() < 2 || (only_equivalent && !drawn)) return {};
  std::string text = "Equal in all ranked objectives: " + enumerated(names, " and ", sharers_named);
  if (drawn) {
    text += fmt::format("; they share the first place in {} of the draws",
                        share_text(designs.front().distribution->first_shared));
  }
  return {{text}};
}

std::string band_headings(const Bands& bands) {
  std::string text;
  for (const ObjectiveBand& entry : bands) {
    for (const char* part : {"median", "p5", "p95"}) {
      text += fmt::format(",{}_{}", row(entry.objective).name, part);
    }
  }
  return text;
}

std::string band_cells(const Bands& bands) {
  std::string text;
  for (const ObjectiveBand& entry : bands) {
    for (const double number : {entry.band.median, entry.band.low, entry.band.high}) {
      text += "," + csv_number(number);
    }
  }
  return text;
}

Json bands_json(const Bands& bands) {
  Json json = Json::object();
  for (const ObjectiveBand& entry : bands) {
    json[row(entry.objective).name] = {{"median", number(entry.band.median)},
                                       {"p5", number(entry.band.low)},
                                       {"p95", number(entry.band.high)}};
  }
  return json;
}

std::vector<DocumentLine> robust_lines(const std::optional<RobustFirst>& first) {
  if (!first) return {};
  const auto& [nominal, robust, by_score, over_draws] = *first;
  if (is_same(*first)) {
    return {
        {fmt::format("It is also the most robust design {}: {} {}, nominal {}", over_words(*first),
                     measure_words(*first), fixed(nominal.p5), fixed(nominal.value))}};
  }
  return {{fmt::format("Most robust design {}: {}: {} {} (best: {}, {}); nominal {} ({})",
                       over_words(*first), design_name(robust.design), measure_words(*first),
                       fixed(robust.p5), fixed(nominal.p5), signed_percent(-nominal_loss(*first)),
                       fixed(robust.value), signed_percent(-robust_loss(*first)))}};
}

Json robust_json(const std::optional<RobustFirst>& first) {
  if (!first) return nullptr;
  return {{"by", first->by_score ? "score" : "product"},
          {"over", first->over_draws ? "draws" : "contacts"},
          {"quantile", 0.05},
          {"nominal", robust_design_json(first->nominal, nominal_loss(*first))},
          {"robust", robust_design_json(first->robust, robust_loss(*first))}};
}

}  // namespace reeve::reports
