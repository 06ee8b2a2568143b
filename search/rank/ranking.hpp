// The order of designs, total and documented:
//   1. front by front, over the chosen objectives (pareto.hpp);
//   2. within a front, by the product of mean uniformity and mean efficiency, greatest first: the
//      hypervolume that a design covers alone; or by the score, if that is asked for;
//   3. fewer parts (sheaths + pulleys + knots);
//   4. the word, byte by byte.
#pragma once

#include <cstddef>
#include <initializer_list>
#include <string>
#include <utility>
#include <vector>

#include "search/evaluate/objectives.hpp"

namespace reeve::search {

struct Order {
  std::vector<Objective> objectives{Objective::uniformity_mean, Objective::efficiency_mean};
  bool by_score = false;  // within a front

  Order() = default;
  // Objectives alone are an order.
  Order(std::vector<Objective> chosen, bool score = false)
      : objectives(std::move(chosen)), by_score(score) {}
  Order(std::initializer_list<Objective> chosen, bool score = false)
      : objectives(chosen), by_score(score) {}
};

struct Design {
  std::string word;
  ObjectiveValues values{};
};

struct RankedDesign {
  Design design;
  int front = 0;
  std::size_t rank = 0;   // from 1
  std::size_t given = 0;  // its index among the designs that were ranked
};

// Rule 2, unless by the score.
// Sheaths, pulleys, knots, blocks and bars.
double part_total(const ObjectiveValues& values);

double uniformity_times_efficiency(const ObjectiveValues& values);

// Value by which rule 2 orders designs.
double decisive_value(const ObjectiveValues& values, const Order& order);

// Objectives that rules 2 and 3 use.
std::vector<Objective> within_front_objectives(const Order& order);

// Rules 2 to 4.
bool precedes_within_front(const Design& a, const Design& b, const Order& order);

// Best first.
std::vector<RankedDesign> rank(std::vector<Design> designs, const Order& order);

// The designs that are best in one objective.
struct BestDesigns {
  Objective objective{};
  double value = 0;
  std::vector<std::string> words;  // sorted by rank
  std::size_t count = 0;           // number of designs with that value, named or not
};

// Returns the best for each objective, in the order of their table, with at most `named` words
// each. Returns nothing if `ranked` is empty.
std::vector<BestDesigns> best_by_objective(const std::vector<RankedDesign>& ranked,
                                           std::size_t named);

}  // namespace reeve::search
