#include "tests/support/part_graph.hpp"

#include <boost/graph/connected_components.hpp>
#include <boost/graph/isomorphism.hpp>
#include <boost/range/iterator_range.hpp>

#include <algorithm>
#include <utility>

namespace reeve::testing {
namespace {

std::size_t mixed(std::size_t seed, std::size_t value) {
  seed ^= value + 0x9e3779b97f4a7c15U + (seed << 6U) + (seed >> 2U);
  return seed * 0xff51afd7ed558ccdU;
}

std::size_t hash_of_sorted(std::vector<std::size_t>& values, std::size_t seed) {
  std::sort(values.begin(), values.end());
  for (const std::size_t value : values) seed = mixed(seed, value);
  return seed;
}

// A Weisfeiler-Leman hash: equal for isomorphic graphs, since it never looks at vertex numbers.
// Unequal graphs may share it (or collide), so it only chooses the bucket; isomorphism decides.
std::size_t bucket_of(const Graph& graph) {
  std::vector<std::size_t> colours;
  std::vector<std::size_t> refined(boost::num_vertices(graph));
  std::vector<std::size_t> neighbours;
  for (Vertex v = 0; v < boost::num_vertices(graph); ++v) colours.push_back(graph[v].colour);
  constexpr int rounds = 6;  // more changes no count, fewer only fills buckets more
  for (int round = 0; round < rounds; ++round) {
    for (Vertex v = 0; v < boost::num_vertices(graph); ++v) {
      neighbours.clear();
      for (const Vertex w : boost::make_iterator_range(boost::adjacent_vertices(v, graph)))
        neighbours.push_back(colours[w]);
      refined[v] = hash_of_sorted(neighbours, colours[v]);
    }
    colours.swap(refined);
  }
  return hash_of_sorted(colours, 0);
}

struct ColourOf {
  using argument_type = Vertex;
  using result_type = std::size_t;
  const Graph* graph;
  std::size_t operator()(Vertex v) const { return (*graph)[v].colour; }
};

bool same_routing(const Graph& a, const Graph& b, std::size_t colours) {
  if (boost::num_vertices(a) != boost::num_vertices(b)) return false;
  std::vector<Vertex> mapping(boost::num_vertices(a));
  const auto index_a = boost::get(boost::vertex_index, a);
  const auto index_b = boost::get(boost::vertex_index, b);
  return boost::isomorphism(a, b, boost::make_iterator_property_map(mapping.begin(), index_a),
                            ColourOf{&a}, ColourOf{&b}, colours, index_a, index_b);
}

void count_class(Graph graph, RoutingCounts& counts) {
  std::size_t carriages = 0;
  for (Vertex v = 0; v < boost::num_vertices(graph); ++v) {
    if (!graph[v].carriage) continue;
    boost::clear_vertex(v, graph);
    ++carriages;
  }
  std::vector<std::size_t> component(boost::num_vertices(graph));
  const std::size_t components = boost::connected_components(
      graph,
      boost::make_iterator_property_map(component.begin(), boost::get(boost::vertex_index, graph)));
  const std::size_t tendons = components - carriages;
  std::vector<bool> has_motor(components, false);
  for (Vertex v = 0; v < component.size(); ++v)
    if (graph[v].motor || graph[v].carriage) has_motor[component[v]] = true;
  const bool actuated = std::find(has_motor.begin(), has_motor.end(), false) == has_motor.end();

  counts.all += 1;
  if (actuated) counts.actuated += 1;
  if (actuated && tendons == 1) counts.one_tendon += 1;
}

}  // namespace

// Not boost::add_vertex(part, graph): that overload looks vertices up by name, and g++ 12 warns
// inside it when sanitizers are on.
Vertex add_part(const Part& part, Graph& graph) {
  const Vertex v = boost::add_vertex(graph);
  graph[v] = part;
  return v;
}

void GraphClasses::add(Graph graph) {
  std::vector<Graph>& bucket = representatives_[bucket_of(graph)];
  const auto is_known = [&](const Graph& known) { return same_routing(known, graph, colours_); };
  if (std::any_of(bucket.begin(), bucket.end(), is_known)) return;
  count_class(graph, counts_);
  bucket.push_back(std::move(graph));
}

}  // namespace reeve::testing
