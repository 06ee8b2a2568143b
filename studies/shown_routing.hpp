// One routing in full, solved in each of some grasps.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "catalog/catalogue.hpp"
#include "causes/model.hpp"
#include "core/grasp.hpp"
#include "core/network.hpp"
#include "core/part_prices.hpp"
#include "core/performance.hpp"
#include "core/routing.hpp"
#include "core/tension/tension.hpp"
#include "search/evaluate/objectives.hpp"
#include "studies/shown_hand.hpp"

namespace reeve::studies {

struct ShownGrasp {
  Grasp grasp;
  TensionState state;
  Performance performance;
};

// A routing with its tensions.
struct SolvedRouting {
  std::string word;
  std::string canonical;
  std::string name;      // "" if it has none
  bool by_word = false;  // true if its user wrote the word, which is its title then
  Direction direction = Direction::pull;
  Model model;
  bool own_hardware = false;      // the model's is from the catalogue's mechanism
  std::uint64_t unconverged = 0;  // tension solves
  Network network;
  std::vector<ShownGrasp> grasps;

  bool is_named() const { return !by_word && !name.empty(); }
  // "TR3: F-1-P-2-F", or the word alone.
  std::string title() const { return is_named() ? name + ": " + word : word; }
};

// A routing with its tensions and objectives.
struct ShownRouting : SolvedRouting {
  ObjectiveValues values{};            // over these grasps
  std::vector<Grasp> smallest_jams{};  // smallest jams over all grasps (core/tension/jamming.hpp)
  std::optional<ShownHand> hand{};
  std::optional<PartPrices> prices{};  // without them the cost among the values is infinite
};

SolvedRouting solved_routing(const Routing& routing, const Model& model, const GraspSet& grasps,
                             Direction direction, const Catalogue& catalogue);

ShownRouting shown_routing(const Routing& routing, const Model& model, const GraspSet& grasps,
                           Direction direction, const Catalogue& catalogue,
                           const std::optional<PartPrices>& prices = std::nullopt);

}  // namespace reeve::studies
