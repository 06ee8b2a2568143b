#include "search/uncertainty/sweep.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <string>
#include <string_view>
#include <utility>

#include "core/error.hpp"
#include "core/nearest_name.hpp"
#include "core/notation.hpp"
#include "core/text.hpp"
#include "search/evaluate/evaluation.hpp"
#include "search/rank/equivalent.hpp"
#include "search/rank/tradeoff.hpp"
#include "search/uncertainty/coefficient_box.hpp"

namespace reeve::search {
namespace {

constexpr std::array<CoefficientRow, 5> coefficients{{
    {Coefficient::mu, "mu", "friction coefficient of tubes and sheaths alike", "", 1},
    {Coefficient::tube_mu, "tube_mu", "friction coefficient of the tubes", "", 1},
    {Coefficient::sheath_mu, "sheath_mu", "friction coefficient of the sheaths", "", 1},
    {Coefficient::bearing_mu, "bearing_mu", "friction coefficient of the bearings", "", 1},
    {Coefficient::sheath_angle, "sheath_angle", "wrap angle of the sheaths", "rad", 50},
}};

InputError no_sweep(const std::string& text, const std::string& expected) {
  return InputError({.what = "sweep", .value = text, .expected = expected});
}

std::vector<std::string> coefficient_names() {
  std::vector<std::string> names;
  for (const CoefficientRow& about : coefficients) names.emplace_back(about.name);
  return names;
}

bool sets_tubes(Coefficient coefficient) {
  return coefficient == Coefficient::mu || coefficient == Coefficient::tube_mu;
}

bool sets_sheaths(Coefficient coefficient) {
  return coefficient == Coefficient::mu || coefficient == Coefficient::sheath_mu;
}

bool would_replace(const Effect& effect, Coefficient coefficient) {
  const std::string_view name = effect.cause->name();
  return (name == "tube_friction" && sets_tubes(coefficient)) ||
         (name == "sheath_friction" && sets_sheaths(coefficient)) ||
         (name == "bearing_friction" && coefficient == Coefficient::bearing_mu);
}

// The block follows the bearing if the file gives only its wrap angle.
bool is_like_bearing(const Hardware& hardware) {
  return !hardware.block || hardware.block->mu == hardware.bearing.mu;
}

// The designs as one value of the coefficient ranks them.
struct SweptRanking {
  std::vector<ObjectiveValues> values;
  std::vector<std::size_t> places;
  std::vector<std::size_t> first;
};

class SweepRanker {
 public:
  SweepRanker(const std::vector<Routing>& routings, const SweepOptions& options)
      : routings_(routings), options_(options) {
    for (const Routing& routing : routings) words_.push_back(to_word(routing));
  }

  SweptRanking at(double coefficient) const {
    const UncertaintyOptions& evaluated = options_.uncertainty;
    DesignEvaluator evaluator(
        at_coefficient(evaluated.nominal, options_.over.coefficient, coefficient), evaluated.grasps,
        evaluated.score, evaluated.prices);
    SweptRanking result;
    std::vector<Design> designs;
    for (std::size_t i = 0; i < routings_.size(); ++i) {
      designs.push_back({words_[i], evaluator.evaluate(routings_[i])});
      result.values.push_back(designs.back().values);
    }
    result.places = places_of(std::move(designs), evaluated.order);
    for (std::size_t i = 0; i < result.places.size(); ++i) {
      if (result.places[i] == 1) result.first.push_back(i);
    }
    return result;
  }

 private:
  const std::vector<Routing>& routings_;
  const SweepOptions& options_;
  std::vector<std::string> words_;
};

// Finds where the lead changes between two values whose first designs are known. The changes come
// in order.
class LeadSearch {
 public:
  LeadSearch(const SweepRanker& ranker, double resolution)
      : ranker_(ranker), resolution_(resolution) {}

  void between(double low, const std::vector<std::size_t>& first_low, double high,
               const std::vector<std::size_t>& first_high, std::vector<SweepLead>& leads) const {
    if (first_low == first_high) return;
    const double middle = low + (high - low) / 2;
    if (high - low <= resolution_ || middle <= low || middle >= high) {
      leads.back().to = middle;
      leads.push_back({middle, middle, first_high});
      return;
    }
    const std::vector<std::size_t> first = ranker_.at(middle).first;
    between(low, first_low, middle, first, leads);
    between(middle, first, high, first_high, leads);
  }

 private:
  const SweepRanker& ranker_;
  double resolution_;
};

// Without those that are no longer than a crossing, whose neighbours then meet in their middle.
std::vector<SweepLead> that_last(const std::vector<SweepLead>& leads, double least) {
  std::vector<SweepLead> lasting;
  for (const SweepLead& lead : leads) {
    if (leads.size() > 1 && lead.to - lead.from < least) continue;
    if (!lasting.empty() && lasting.back().first == lead.first) {
      lasting.back().to = lead.to;
      continue;
    }
    lasting.push_back(lead);
  }
  if (lasting.empty()) return leads;
  for (std::size_t i = 1; i < lasting.size(); ++i) {
    const double meet = (lasting[i - 1].to + lasting[i].from) / 2;
    lasting[i - 1].to = lasting[i].from = meet;
  }
  lasting.front().from = leads.front().from;
  lasting.back().to = leads.back().to;
  return lasting;
}

std::vector<double> equally_distant(const Interval& range, std::size_t steps) {
  std::vector<double> values;
  for (std::size_t i = 0; i < steps; ++i) {
    const double share = static_cast<double>(i) / static_cast<double>(steps);
    values.push_back(i == 0 ? range.low : on_grid(range.low + (range.high - range.low) * share));
  }
  values.push_back(range.high);
  return values;
}

std::vector<SweepLead> leads_of(const Sweep& sweep,
                                const std::vector<std::vector<std::size_t>>& first,
                                const SweepRanker& ranker) {
  const double width = sweep.over.range.high - sweep.over.range.low;
  const LeadSearch search(ranker, 1e-10 * width);
  std::vector<SweepLead> leads{{sweep.at.front(), sweep.at.front(), first.front()}};
  for (std::size_t i = 0; i + 1 < sweep.at.size(); ++i) {
    search.between(sweep.at[i], first[i], sweep.at[i + 1], first[i + 1], leads);
  }
  leads.back().to = sweep.at.back();
  return that_last(leads, 1e-6 * width);
}

// Without draws of nothing; nothing if stopped.
std::optional<std::vector<Bands>> bands_at(double at, const std::vector<Routing>& routings,
                                           const SweepOptions& options,
                                           const std::atomic<bool>* stop) {
  if (!options.draws) return std::vector<Bands>(routings.size());
  const UncertaintyOptions& drawn = options.uncertainty;
  return drawn_bands(routings, swept_objectives(drawn.order), drawn,
                     [&](std::uint64_t draw) {
                       return at_coefficient(draw_model(drawn, draw), options.over.coefficient, at);
                     },
                     {{}, stop});
}

void add_point(const SweptRanking& ranking, const std::vector<Bands>& bands, Sweep& result) {
  for (std::size_t i = 0; i < bands.size(); ++i) {
    for (SweepCurve& curve : result.designs[i]) {
      curve.values.push_back(value(ranking.values[i], curve.objective));
      const Band* band = find_band(bands[i], curve.objective);
      if (band != nullptr) curve.bands.push_back(*band);
    }
    result.places[i].push_back(ranking.places[i]);
  }
}

}  // namespace

const CoefficientRow& row(Coefficient coefficient) {
  return coefficients[static_cast<std::size_t>(coefficient)];
}

CoefficientRange parse_sweep(const std::string& text) {
  const std::size_t equals = std::min(text.find('='), text.size());
  const std::string_view name = trimmed(std::string_view(text).substr(0, equals));
  const auto* about =
      std::find_if(coefficients.begin(), coefficients.end(),
                   [&](const CoefficientRow& candidate) { return name == candidate.name; });
  if (about == coefficients.end()) {
    const std::vector<std::string> names = coefficient_names();
    throw no_sweep(text, fmt::format("one of {}, and its range, such as mu=0.02..0.3{}",
                                     fmt::join(names, ", "), did_you_mean(name, names)));
  }
  const std::string_view range = std::string_view(text).substr(std::min(equals + 1, text.size()));
  const std::size_t dots = range.find("..");
  if (dots != std::string_view::npos) {
    const auto low = number_in(trimmed(range.substr(0, dots)));
    const auto high = number_in(trimmed(range.substr(dots + 2)));
    if (low && high && *low >= 0 && *low < *high && *high <= about->greatest) {
      return {about->coefficient, {*low, *high}};
    }
  }
  throw no_sweep(text, fmt::format("{}= and a lesser and a greater number from 0 to {}{}{} with "
                                   ".. between them, such as mu=0.02..0.3",
                                   about->name, about->greatest, *about->unit == '\0' ? "" : " ",
                                   about->unit));
}

Model at_coefficient(Model model, Coefficient coefficient, double value) {
  Hardware& hardware = model.hardware;
  if (sets_tubes(coefficient)) hardware.tube.mu = value;
  if (sets_sheaths(coefficient)) hardware.sheath.mu = value;
  if (coefficient == Coefficient::bearing_mu) {
    if (hardware.block && is_like_bearing(hardware)) hardware.block->mu = value;
    hardware.bearing.mu = value;
  }
  if (coefficient == Coefficient::sheath_angle) hardware.sheath.angle_rad = value;
  std::erase_if(model.effects,
                [&](const Effect& effect) { return would_replace(effect, coefficient); });
  return model;
}

ValueUse value_use(const Hardware& hardware, Coefficient coefficient) {
  std::vector<ContactKind> kinds;
  if (sets_tubes(coefficient)) kinds.push_back(ContactKind::tube);
  if (coefficient == Coefficient::bearing_mu) {
    kinds.push_back(ContactKind::bearing);
    if (is_like_bearing(hardware)) kinds.push_back(ContactKind::block);
  }
  const bool is_angle = coefficient == Coefficient::sheath_angle;
  if (sets_sheaths(coefficient) || is_angle) kinds.push_back(ContactKind::sheath);
  return {hardware, std::move(kinds), is_angle ? LawValue::angle : LawValue::mu};
}

std::vector<Objective> swept_objectives(const Order& order) {
  std::vector<Objective> objectives = ranked_by(order);
  std::erase_if(objectives, [](Objective objective) { return !depends_on_friction(objective); });
  return objectives;
}

void validate(const SweepOptions& options) {
  if (swept_objectives(options.uncertainty.order).empty()) {
    throw InputError({.what = "sweep",
                      .value = row(options.over.coefficient).name,
                      .expected = "a ranked objective that depends on friction, such as "
                                  "uniformity or efficiency"});
  }
  const Model& nominal = options.uncertainty.nominal;
  std::vector<Model> ends{nominal};
  if (options.draws) {
    std::vector<double> highest;
    for (const Interval& interval : coefficient_box(nominal.hardware, options.uncertainty.ranges)) {
      highest.push_back(interval.high);
    }
    ends.push_back(at_point(nominal, highest));
  }
  try {
    for (const Model& end : ends) {
      validate(effective_hardware(
          at_coefficient(end, options.over.coefficient, options.over.range.high)));
    }
  } catch (const InputError& error) {
    throw error.at(fmt::format("sweep '{}': at its upper end", row(options.over.coefficient).name));
  }
}

std::optional<Sweep> sweep(const std::vector<Routing>& routings, const SweepOptions& options,
                           const Supervision& supervision) {
  validate(options);
  const std::vector<Objective> objectives = swept_objectives(options.uncertainty.order);
  const SweepRanker ranker(routings, options);
  Sweep result{options.over, equally_distant(options.over.range, options.steps), {}, {}, {}};
  result.places.resize(routings.size());
  result.designs.resize(routings.size());
  for (std::vector<SweepCurve>& curves : result.designs) {
    for (const Objective objective : objectives) curves.push_back({objective, {}, {}});
  }
  std::vector<std::vector<std::size_t>> first;
  for (const double at : result.at) {
    if (supervision.stop != nullptr && supervision.stop->load()) return std::nullopt;
    const auto bands = bands_at(at, routings, options, supervision.stop);
    if (!bands) return std::nullopt;
    SweptRanking ranking = ranker.at(at);
    add_point(ranking, *bands, result);
    first.push_back(std::move(ranking.first));
    if (supervision.report) supervision.report({first.size(), result.at.size()});
  }
  result.leads = leads_of(result, first, ranker);
  return result;
}

}  // namespace reeve::search
