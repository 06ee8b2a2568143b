// Random routings, hardware and grasps for the property tests. A seed gives the same trial on every
// machine: nothing here depends on how a standard library implements its distributions.
#pragma once

#include <cstdint>
#include <random>
#include <string>
#include <vector>

#include "core/grasp.hpp"
#include "core/mechanics.hpp"
#include "core/network.hpp"
#include "core/routing.hpp"

namespace reeve::testing {

class Dice {
 public:
  explicit Dice(std::uint64_t seed) : engine_(seed) {}

  int integer(int low, int high);            // low … high, both included
  double real(double low, double high);      // uniform
  double log_real(double low, double high);  // uniform in the logarithm
  bool chance(double probability);

  template <typename Item>
  const Item& pick(const std::vector<Item>& items) {
    return items[static_cast<std::size_t>(integer(0, static_cast<int>(items.size()) - 1))];
  }

  template <typename Item>
  void shuffle(std::vector<Item>& items) {
    for (std::size_t i = items.size(); i > 1; --i) {
      std::swap(items[i - 1], items[static_cast<std::size_t>(integer(0, static_cast<int>(i) - 1))]);
    }
  }

 private:
  std::mt19937_64 engine_;
};

struct RoutingRange {
  int least_fingers = 2;
  int most_fingers = 6;
  bool actuated = true;      // every tendon hangs on the carriage
  bool bare_tendons = true;  // sometimes a tendon without a finger, such as M-F
};

// Open tendons and loops, all joins and ends, both tips, joins side by side, several tendons.
Routing random_routing(Dice& dice, const RoutingRange& range = {});

// Open tendons without blocks, on fingers that they pass or that anchor one or two of their ends:
// flexors and extensors.
Routing random_shared_routing(Dice& dice);

// The same on the carriages of up to four motors, numbered without a gap; often on one.
Routing with_several_motors(Dice& dice, Routing routing);

// Friction of every kind of contact (sometimes 0), lengths, closing weights, overrides for single
// fingers and for single contacts of that network.
Hardware random_hardware(Dice& dice, const Network& network);

// Any set of held fingers; sometimes one in which a tendon jams.
Grasp random_grasp(Dice& dice, int fingers);

struct Trial {
  std::uint64_t seed = 0;
  Routing routing;
  Network network;
  Hardware hardware;
  Grasp grasp;
  Direction direction = Direction::pull;
};

// Of actuated routings: an override needs a contact.
Trial random_trial(std::uint64_t seed, const RoutingRange& range = {});

// What a failing test prints: seed, word, grasp, direction.
std::string to_text(const Trial& trial);

}  // namespace reeve::testing
