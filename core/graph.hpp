// The network of segments (vertices) and contacts (edges) as a Boost.Graph. Its connected
// components are the tendons.
#pragma once

#include <boost/graph/adjacency_list.hpp>

#include <cstddef>
#include <string>
#include <vector>

#include "core/mechanics.hpp"
#include "core/network.hpp"
#include "core/tension/tension.hpp"

namespace reeve::core {

struct ContactEdge {
  Contact contact;
  std::size_t index = 0;  // in Network::contacts
  std::size_t left = 0;   // an undirected edge does not keep which end is which
};

using NetworkGraph =
    boost::adjacency_list<boost::vecS, boost::vecS, boost::undirectedS, Segment, ContactEdge>;

NetworkGraph graph(const Network& network);

// For each segment, the number (from 0) of the tendon that it belongs to.
std::vector<std::size_t> tendons(const NetworkGraph& graph);

// Names the first tendon that hangs on no motor, in an InputError. `word` is the routing's.
void require_actuated(const NetworkGraph& graph, const std::string& word);

// The network in the language of Graphviz; with a state also tensions and sliding directions.
std::string to_dot(const Network& network, const std::string& title,
                   const TensionState* state = nullptr);

}  // namespace reeve::core
