#include "search/uncertainty/uncertainty.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <utility>

#include "core/error.hpp"
#include "core/notation.hpp"
#include "numerics/parallel.hpp"
#include "search/evaluate/evaluation.hpp"
#include "search/rank/equivalent.hpp"
#include "search/uncertainty/coefficient_box.hpp"

namespace reeve::search {
namespace {

// The places of the routings in one draw, in their order, and which of them meet all constraints.
struct DrawnPlaces {
  std::vector<std::uint32_t> places;
  std::vector<bool> meets;  // empty without constraints
  bool first_is_shared = false;
};

DrawnPlaces drawn_places(std::vector<Design> designs, const UncertaintyOptions& options) {
  DrawnPlaces result;
  if (!options.constraints.empty()) {
    for (const Design& design : designs) {
      result.meets.push_back(first_failure(options.constraints, design.values) == 0);
    }
  }
  const std::vector<std::size_t> places = places_of(std::move(designs), options.order);
  result.first_is_shared = std::count(places.begin(), places.end(), std::size_t{1}) > 1;
  for (const std::size_t place : places) {
    result.places.push_back(static_cast<std::uint32_t>(place));
  }
  return result;
}

// The smallest rank that at least this share of the draws do not exceed.
double quantile(const std::vector<std::uint32_t>& sorted, double share) {
  const double wanted = share * static_cast<double>(sorted.size());
  auto index = static_cast<std::size_t>(wanted);
  if (static_cast<double>(index) == wanted && index > 0) --index;
  return sorted[std::min(index, sorted.size() - 1)];
}

RankDistribution distribution(const std::vector<DrawnPlaces>& draws, std::size_t design) {
  std::vector<std::uint32_t> places;
  double first = 0;
  double shared = 0;
  for (const DrawnPlaces& draw : draws) {
    places.push_back(draw.places[design]);
    if (places.back() > 1) continue;
    ++first;
    if (draw.first_is_shared) ++shared;
  }
  std::sort(places.begin(), places.end());
  const auto count = static_cast<double>(draws.size());
  return {first / count, quantile(places, 0.5), quantile(places, 0.05), quantile(places, 0.95),
          shared / count};
}

double share_that_meets(const std::vector<DrawnPlaces>& draws, std::size_t design) {
  const auto met = std::count_if(draws.begin(), draws.end(),
                                 [&](const DrawnPlaces& draw) { return draw.meets[design]; });
  return static_cast<double>(met) / static_cast<double>(draws.size());
}

// Goes through all draws, once or several times, in slices, so that progress can be told and a stop
// heard between them.
class DrawLoop {
 public:
  using Work = std::function<void(std::size_t draw)>;

  DrawLoop(const UncertaintyOptions& options, const Supervision& supervision, std::size_t times)
      : workers_(options.threads),
        draws_(options.draws),
        supervision_(supervision),
        total_(times * options.draws) {}

  Workers& workers() { return workers_; }

  // False if stopped.
  bool pass(const Work& work) {
    const std::size_t slice = std::max<std::size_t>(workers_.count() * 4, 16);
    for (std::size_t begin = 0; begin < draws_; begin += slice) {
      const std::size_t size = std::min(slice, draws_ - begin);
      workers_.for_each_block(size, 1, [&](const IndexBlock& block) {
        for (std::size_t d = begin + block.begin; d < begin + block.end; ++d) work(d);
      });
      done_ += size;
      if (supervision_.report) supervision_.report({done_, total_});
      const bool more = done_ < total_;
      if (more && supervision_.stop != nullptr && supervision_.stop->load()) return false;
    }
    return true;
  }

 private:
  Workers workers_;
  std::size_t draws_;
  const Supervision& supervision_;
  std::size_t total_;
  std::size_t done_ = 0;
};

std::size_t designs_at_once(const UncertaintyOptions& options, std::size_t objectives) {
  const std::size_t each = std::max<std::size_t>(1, options.draws * (objectives + 1));
  return std::max<std::size_t>(1, options.values_at_once / each);
}

std::size_t passes(std::size_t designs, std::size_t at_once) {
  return (std::max<std::size_t>(designs, 1) + at_once - 1) / at_once;
}

// Designs of one draw have tendons in common.
DesignEvaluator evaluator_of(const Model& model, const UncertaintyOptions& options) {
  DesignEvaluator evaluator(model, options.grasps, options.score, options.prices);
  evaluator.share_trees();
  return evaluator;
}

// Returns a scope that has jams in all grasps only if something is judged by them, since friction
// does not move them. Quantiles over contacts are likewise left out, since the draws tell of them.
EvaluationScope drawn_scope(const UncertaintyOptions& options) {
  std::vector<Objective> judged = ranked_by(options.order);
  for (const Constraint& constraint : options.constraints) judged.push_back(constraint.objective);
  judged.push_back(Objective::score);
  EvaluationScope scope;
  const EvaluationScope needed = scope_for(judged, options.score);
  scope.jamming = needed.jamming;
  scope.contacts = needed.contacts;
  return scope;
}

struct DrawnBands {
  std::vector<Bands> bands;
  std::vector<Band> decisive;  // of decisive_value
};

// Values of the designs `begin` to `end` of a list in each draw, from which their bands are made.
class DrawnValues {
 public:
  DrawnValues(const std::vector<Objective>& objectives, const UncertaintyOptions& options,
              std::size_t begin, std::size_t end)
      : objectives_(objectives),
        order_(options.order),
        draws_(options.draws),
        begin_(begin),
        end_(end),
        values_((end - begin) * (objectives.size() + 1) * draws_) {}

  std::size_t begin() const { return begin_; }
  std::size_t end() const { return end_; }

  // Does nothing for designs that are not kept here. Each draw of each design once, from any
  // thread.
  void keep(std::size_t design, std::size_t draw, const ObjectiveValues& values) {
    if (design < begin_ || design >= end_) return;
    std::size_t at = first_of(design - begin_, 0) + draw;
    for (const Objective objective : objectives_) {
      values_[at] = value(values, objective);
      at += draws_;
    }
    values_[at] = decisive_value(values, order_);
  }

  void add_bands(Workers& workers, DrawnBands& drawn) const {
    drawn.bands.resize(end_);
    drawn.decisive.resize(end_);
    workers.for_each_block(end_ - begin_, 16, [&](const IndexBlock& block) {
      for (std::size_t i = block.begin; i < block.end; ++i) {
        for (std::size_t k = 0; k < objectives_.size(); ++k) {
          drawn.bands[begin_ + i].push_back({objectives_[k], band(i, k)});
        }
        drawn.decisive[begin_ + i] = band(i, objectives_.size());
      }
    });
  }

 private:
  std::size_t first_of(std::size_t design, std::size_t column) const {
    return (design * (objectives_.size() + 1) + column) * draws_;
  }

  Band band(std::size_t design, std::size_t column) const {
    const auto from = values_.begin() + static_cast<std::ptrdiff_t>(first_of(design, column));
    return band_of({from, from + static_cast<std::ptrdiff_t>(draws_)});
  }

  const std::vector<Objective>& objectives_;
  const Order& order_;
  std::size_t draws_;
  std::size_t begin_;
  std::size_t end_;
  std::vector<double> values_;  // [design][objective, and last the decisive value][draw]
};

// Adds the bands of the routings that have none yet. Each pass takes as many of them as there is
// room for.
bool add_bands(const std::vector<Routing>& routings, const std::vector<Objective>& objectives,
               const UncertaintyOptions& options, const DrawnModel& model, DrawLoop& loop,
               DrawnBands& drawn) {
  const EvaluationScope scope = scope_for(objectives, options.score);
  const std::size_t at_once = designs_at_once(options, objectives.size());
  while (drawn.bands.size() < routings.size()) {
    const std::size_t begin = drawn.bands.size();
    DrawnValues values(objectives, options, begin, std::min(begin + at_once, routings.size()));
    const bool finished = loop.pass([&](std::size_t draw) {
      DesignEvaluator evaluator = evaluator_of(model(draw), options);
      for (std::size_t i = values.begin(); i < values.end(); ++i) {
        values.keep(i, draw, evaluator.evaluate(routings[i], scope));
      }
    });
    if (!finished) return false;
    values.add_bands(loop.workers(), drawn);
  }
  return true;
}

}  // namespace

Model draw_model(const UncertaintyOptions& options, std::uint64_t draw) {
  return draw_model(options.nominal, options.ranges, options.seed, draw);
}

void validate(const UncertaintyOptions& options, std::size_t designs) {
  constexpr std::size_t most = 500'000'000;  // ranks of four bytes
  if (options.draws == 0 || designs > most / options.draws) {
    throw InputError({.what = fmt::format("draws {} for {} designs", options.draws, designs),
                      .expected = fmt::format(
                          "from 1 to {} ranks in all; keep fewer designs or draw less", most)});
  }
  std::vector<double> highest;
  for (const Interval& interval : coefficient_box(options.nominal.hardware, options.ranges)) {
    highest.push_back(interval.high);
  }
  try {
    validate(effective_hardware(at_point(options.nominal, highest)));
  } catch (const InputError& error) {
    throw error.at("at the upper end of the uncertainty's ranges");
  }
}

std::optional<DrawnDesigns> drawn_designs(const std::vector<Routing>& routings,
                                          const UncertaintyOptions& options,
                                          const Supervision& supervision) {
  validate(options, routings.size());
  std::vector<std::string> words;
  for (const Routing& routing : routings) words.push_back(to_word(routing));
  const DrawnModel model = [&](std::uint64_t draw) { return draw_model(options, draw); };
  const std::vector<Objective> objectives =
      friction_objectives(evaluator_of(options.nominal, options).has_hand());
  const std::size_t at_once = designs_at_once(options, objectives.size());
  DrawLoop loop(options, supervision, passes(routings.size(), at_once));
  std::vector<DrawnPlaces> by_draw(options.draws);
  const EvaluationScope scope = drawn_scope(options);
  DrawnDesigns result;
  DrawnBands bands;
  {
    DrawnValues values(objectives, options, 0, std::min(at_once, routings.size()));
    const bool finished = loop.pass([&](std::size_t draw) {
      DesignEvaluator evaluator = evaluator_of(model(draw), options);
      std::vector<Design> designs;
      for (std::size_t i = 0; i < routings.size(); ++i) {
        designs.push_back({words[i], evaluator.evaluate(routings[i], scope)});
        values.keep(i, draw, designs.back().values);
      }
      by_draw[draw] = drawn_places(std::move(designs), options);
    });
    if (!finished) return std::nullopt;
    values.add_bands(loop.workers(), bands);
  }
  for (std::size_t i = 0; i < routings.size(); ++i) {
    result.ranks.push_back(distribution(by_draw, i));
    if (options.constraints.empty()) continue;
    result.constraints_met.push_back(share_that_meets(by_draw, i));
  }
  by_draw.clear();
  if (!add_bands(routings, objectives, options, model, loop, bands)) return std::nullopt;
  result.bands = std::move(bands.bands);
  result.decisive = std::move(bands.decisive);
  return result;
}

std::optional<std::vector<Bands>> drawn_bands(const std::vector<Routing>& routings,
                                              const std::vector<Objective>& objectives,
                                              const UncertaintyOptions& options,
                                              const DrawnModel& model,
                                              const Supervision& supervision) {
  const std::size_t at_once = designs_at_once(options, objectives.size());
  DrawLoop loop(options, supervision, passes(routings.size(), at_once));
  DrawnBands drawn;
  if (!add_bands(routings, objectives, options, model, loop, drawn)) return std::nullopt;
  return std::move(drawn.bands);
}

}  // namespace reeve::search
