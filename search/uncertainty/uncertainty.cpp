#include "search/uncertainty/uncertainty.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <utility>

#include "core/error.hpp"
#include "core/notation.hpp"
#include "numerics/parallel.hpp"
#include "search/judge/evaluation.hpp"
#include "search/uncertainty/coefficient_box.hpp"

namespace reeve::search {
namespace {

// The ranks of the routings, in their order, for one draw of the model.
std::vector<std::uint32_t> ranks(const std::vector<Routing>& routings,
                                 const std::vector<std::string>& words, const Model& model,
                                 const UncertaintyOptions& options) {
  DesignEvaluator evaluator(model, options.grasps, options.score, options.prices);
  std::vector<Design> designs;
  for (std::size_t i = 0; i < routings.size(); ++i) {
    designs.push_back({words[i], evaluator.evaluate(routings[i])});
  }
  std::vector<std::uint32_t> result(designs.size());
  for (const RankedDesign& ranked : rank(std::move(designs), options.order)) {
    result[ranked.given] = static_cast<std::uint32_t>(ranked.rank);
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

RankDistribution distribution(std::vector<std::uint32_t> ranks) {
  std::sort(ranks.begin(), ranks.end());
  const auto first = std::upper_bound(ranks.begin(), ranks.end(), 1U) - ranks.begin();
  return {static_cast<double>(first) / static_cast<double>(ranks.size()), quantile(ranks, 0.5),
          quantile(ranks, 0.05), quantile(ranks, 0.95)};
}

}  // namespace

Model draw_model(const UncertaintyOptions& options, std::uint64_t draw) {
  const CoefficientBox box = coefficient_box(options.nominal.hardware, options.ranges);
  return at_point(options.nominal, drawn_point(box, options.seed, draw));
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

std::optional<std::vector<RankDistribution>> rank_distributions(
    const std::vector<Routing>& routings, const UncertaintyOptions& options,
    const Supervision& supervision) {
  validate(options, routings.size());
  std::vector<std::string> words;
  for (const Routing& routing : routings) words.push_back(to_word(routing));
  std::vector<std::vector<std::uint32_t>> by_draw(options.draws);
  Workers workers(options.threads);
  // In slices, so that progress can be told and a stop heard between them.
  const std::size_t slice = std::max<std::size_t>(workers.count() * 4, 16);
  for (std::size_t begin = 0; begin < options.draws; begin += slice) {
    const std::size_t size = std::min(slice, options.draws - begin);
    workers.for_each_block(size, 1, [&](const IndexBlock& block) {
      for (std::size_t d = begin + block.begin; d < begin + block.end; ++d) {
        by_draw[d] = ranks(routings, words, draw_model(options, d), options);
      }
    });
    if (supervision.report) supervision.report({begin + size, options.draws});
    const bool more = begin + size < options.draws;
    if (more && supervision.stop != nullptr && supervision.stop->load()) return std::nullopt;
  }
  std::vector<RankDistribution> result;
  for (std::size_t i = 0; i < routings.size(); ++i) {
    std::vector<std::uint32_t> of_design;
    for (const auto& draw : by_draw) of_design.push_back(draw[i]);
    result.push_back(distribution(std::move(of_design)));
  }
  return result;
}

}  // namespace reeve::search
