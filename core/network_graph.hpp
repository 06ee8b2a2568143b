// The network of segments (vertices) and contacts (edges) as a Boost.Graph. Further edges lead from
// the first tail of a block to whatever else pulls at it, so that the connected components are the
// tendons, or the trees of tendons that blocks tie together.
#pragma once

#include <boost/graph/adjacency_list.hpp>

#include <cstddef>
#include <string>
#include <vector>

#include "core/network.hpp"

namespace reeve::core {

struct ContactEdge {
  Contact contact;
  std::size_t index = 0;  // in Network::contacts
  std::size_t left = 0;   // an undirected edge does not keep which end is which
  std::string block;      // the name of the block at which it is
  bool is_tie = false;    // true from a block's tail to another of its strands: no contact
};

using NetworkGraph =
    boost::adjacency_list<boost::vecS, boost::vecS, boost::undirectedS, Segment, ContactEdge>;

NetworkGraph graph(const Network& network);

// For each segment, the number (from 0) of the tendon, or of the tree, that it belongs to.
std::vector<std::size_t> tendons(const NetworkGraph& graph);

}  // namespace reeve::core
