// The network of a routing word, and its tensions by the names of its segments.
#pragma once

#include <stdexcept>
#include <string>
#include <utility>

#include "core/contact_name.hpp"
#include "core/notation.hpp"
#include "core/tension/tension.hpp"

namespace reeve::testing {

inline Network network_of(const std::string& word) { return expand(parse_routing(word)); }

struct SolvedNetwork {
  Network network;
  TensionState state;

  double operator[](const std::string& segment) const {
    const auto found = find_segment(network, parse_segment(segment));
    if (!found) throw std::logic_error("no segment " + segment);
    return state.tension[*found];
  }
  double slip(const std::string& contact) const {
    return state.slip[find_contact(network, contact).value()];
  }
};

inline SolvedNetwork solved_network(const std::string& word, const Hardware& hardware,
                                    Grasp grasp = {}, Direction direction = Direction::pull) {
  Network network = network_of(word);
  TensionState state = tensions(network, mechanics(network, hardware), grasp, direction);
  return {std::move(network), std::move(state)};
}

}  // namespace reeve::testing
