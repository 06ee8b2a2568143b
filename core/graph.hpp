// A network looked at as a graph: whether the motor reaches all of it, and its drawing by Graphviz.
#pragma once

#include <string>

#include "core/network.hpp"
#include "core/routing.hpp"
#include "core/tension/tension.hpp"

namespace reeve::core {

// Names the first tendon that hangs on no motor, in an InputError. `word` is the routing's.
void require_actuated(const Network& network, const std::string& word);

// The first strand that is an extensor or a second flexor; nullptr if there is none.
const Segment* second_tendon(const Network& network);

// The network in the language of Graphviz; with a state also tensions and sliding directions.
std::string to_dot(const Network& network, const std::string& title,
                   const TensionState* state = nullptr);

}  // namespace reeve::core
