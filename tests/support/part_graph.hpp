// Routings as graphs of parts, and how many of them are different.
#pragma once

#include <boost/graph/adjacency_list.hpp>

#include <cstddef>
#include <map>
#include <vector>

#include "tests/support/counting.hpp"

namespace reeve::testing {

// Edges say what touches what. Strands are vertices rather than edges so that no two edges are
// parallel, whatever is joined to what.
struct Part {
  std::size_t colour = 0;
  bool motor = false;
  bool carriage = false;  // joins what hangs on one motor, and is no part of a tendon
};
using Graph = boost::adjacency_list<boost::vecS, boost::vecS, boost::undirectedS, Part>;
using Vertex = Graph::vertex_descriptor;

Vertex add_part(const Part& part, Graph& graph);

// Graphs up to isomorphism that keeps the colours, which are the numbers below `colours`.
class GraphClasses {
 public:
  explicit GraphClasses(std::size_t colours) : colours_(colours) {}

  // Counts it unless one like it was there before.
  void add(Graph graph);
  const RoutingCounts& counts() const { return counts_; }

 private:
  std::size_t colours_;
  std::map<std::size_t, std::vector<Graph>> representatives_;
  RoutingCounts counts_;
};

}  // namespace reeve::testing
