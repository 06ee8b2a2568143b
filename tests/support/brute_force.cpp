#include "tests/support/brute_force.hpp"

#include <boost/graph/adjacency_list.hpp>
#include <boost/graph/connected_components.hpp>
#include <boost/graph/isomorphism.hpp>
#include <boost/range/iterator_range.hpp>

#include <algorithm>
#include <cstddef>
#include <functional>
#include <map>
#include <stdexcept>
#include <utility>
#include <vector>

namespace reeve::testing {
namespace {

struct PartKinds {
  std::size_t tips;
  std::size_t joins;  // passive ones first
  std::size_t passive_joins;
  std::size_t ends;  // motor ones first
  std::size_t motor_ends;
};

std::size_t checked_kinds(int kinds) {
  if (kinds < 0) throw std::invalid_argument("number of part kinds is negative");
  return static_cast<std::size_t>(kinds);
}

PartKinds kinds_of(const CountedParts& parts) {
  const std::size_t passive_joins = checked_kinds(parts.passive_joins);
  const std::size_t motor_ends = checked_kinds(parts.motor_ends);
  return {checked_kinds(parts.tube_like_tips), passive_joins + checked_kinds(parts.motor_joins),
          passive_joins, motor_ends + checked_kinds(parts.fixed_ends), motor_ends};
}

// The definition, literally. Finger f (from 0) has the strands 2f and 2f + 1. A strand that is its
// own partner has an end of kind hand_kind, otherwise a join of that kind leads to its partner.
struct Assignment {
  std::vector<std::size_t> tip_kind;   // by finger
  std::vector<std::size_t> partner;    // by strand
  std::vector<std::size_t> hand_kind;  // by strand
};

using Visitor = std::function<void(const Assignment&)>;

class Enumeration {
 public:
  Enumeration(const PartKinds& kinds, std::size_t fingers, const Visitor& visit)
      : kinds_(kinds),
        visit_(visit),
        current_{std::vector<std::size_t>(fingers), std::vector<std::size_t>(2 * fingers),
                 std::vector<std::size_t>(2 * fingers)},
        taken_(2 * fingers, false) {}

  void run() { choose_tip(0); }

 private:
  void choose_tip(std::size_t finger) {
    if (finger == current_.tip_kind.size()) return choose_hand(0);
    for (std::size_t kind = 0; kind < kinds_.tips; ++kind) {
      current_.tip_kind[finger] = kind;
      choose_tip(finger + 1);
    }
  }

  // Partners are sought among later strands only, so that each pair is met once.
  void choose_hand(std::size_t strand) {
    if (strand == taken_.size()) return visit_(current_);
    if (taken_[strand]) return choose_hand(strand + 1);
    for (std::size_t kind = 0; kind < kinds_.ends; ++kind) {
      set(strand, strand, kind);
      choose_hand(strand + 1);
    }
    for (std::size_t other = strand + 1; other < taken_.size(); ++other)
      if (!taken_[other]) choose_join(strand, other);
  }

  void choose_join(std::size_t strand, std::size_t other) {
    taken_[other] = true;
    for (std::size_t kind = 0; kind < kinds_.joins; ++kind) {
      set(strand, other, kind);
      set(other, strand, kind);
      choose_hand(strand + 1);
    }
    taken_[other] = false;
  }

  void set(std::size_t strand, std::size_t partner, std::size_t kind) {
    current_.partner[strand] = partner;
    current_.hand_kind[strand] = kind;
  }

  const PartKinds& kinds_;
  const Visitor& visit_;
  Assignment current_;
  std::vector<bool> taken_;  // already joined to an earlier strand
};

// Vertices are strands, tips, joins and ends; edges say what touches what. Strands are vertices
// rather than edges so that no two edges are parallel, whatever is joined to what.
struct Part {
  std::size_t colour = 0;
  bool motor = false;
};
using Graph = boost::adjacency_list<boost::vecS, boost::vecS, boost::undirectedS, Part>;
using Vertex = Graph::vertex_descriptor;

// Small consecutive numbers, as boost::isomorphism asks of a vertex invariant. Distinct fingers
// differ by the colours of their tips; their two strands stay alike.
class Palette {
 public:
  Palette(const PartKinds& kinds, std::size_t fingers, bool identical_fingers)
      : kinds_(kinds), fingers_(fingers), identical_fingers_(identical_fingers) {}

  static Part strand() { return {0, false}; }
  Part end(std::size_t kind) const { return {1 + kind, kind < kinds_.motor_ends}; }
  Part join(std::size_t kind) const {
    return {1 + kinds_.ends + kind, kind >= kinds_.passive_joins};
  }
  Part tip(std::size_t kind, std::size_t finger) const {
    const std::size_t shown_finger = identical_fingers_ ? 0 : finger;
    return {first_tip() + kind * fingers_ + shown_finger, false};
  }
  std::size_t size() const { return first_tip() + kinds_.tips * fingers_; }

 private:
  std::size_t first_tip() const { return 1 + kinds_.ends + kinds_.joins; }

  PartKinds kinds_;
  std::size_t fingers_;
  bool identical_fingers_;
};

// Not boost::add_vertex(part, graph): that overload looks vertices up by name, and g++ 12 warns
// inside it when sanitizers are on.
Vertex add_part(const Part& part, Graph& graph) {
  const Vertex v = boost::add_vertex(graph);
  graph[v] = part;
  return v;
}

Graph graph_of(const Assignment& assignment, const Palette& palette) {
  Graph graph;
  std::vector<Vertex> strands;
  for (std::size_t finger = 0; finger < assignment.tip_kind.size(); ++finger) {
    const Vertex tip = add_part(palette.tip(assignment.tip_kind[finger], finger), graph);
    for (int side = 0; side < 2; ++side) {
      strands.push_back(add_part(Palette::strand(), graph));
      boost::add_edge(tip, strands.back(), graph);
    }
  }
  for (std::size_t strand = 0; strand < strands.size(); ++strand) {
    const std::size_t partner = assignment.partner[strand];
    const std::size_t kind = assignment.hand_kind[strand];
    if (partner < strand) continue;  // its join is there already
    const bool is_end = partner == strand;
    const Part part = is_end ? palette.end(kind) : palette.join(kind);
    const Vertex hand = add_part(part, graph);
    boost::add_edge(hand, strands[strand], graph);
    if (!is_end) boost::add_edge(hand, strands[partner], graph);
  }
  return graph;
}

std::size_t mixed(std::size_t seed, std::size_t value) {
  seed ^= value + 0x9e3779b97f4a7c15U + (seed << 6U) + (seed >> 2U);
  return seed * 0xff51afd7ed558ccdU;
}

std::size_t hash_of_sorted(std::vector<std::size_t> values, std::size_t seed) {
  std::sort(values.begin(), values.end());
  for (const std::size_t value : values) seed = mixed(seed, value);
  return seed;
}

std::vector<std::size_t> refined(const Graph& graph, const std::vector<std::size_t>& colours) {
  std::vector<std::size_t> result;
  for (Vertex v = 0; v < boost::num_vertices(graph); ++v) {
    std::vector<std::size_t> neighbours;
    for (const Vertex w : boost::make_iterator_range(boost::adjacent_vertices(v, graph)))
      neighbours.push_back(colours[w]);
    result.push_back(hash_of_sorted(std::move(neighbours), colours[v]));
  }
  return result;
}

// A Weisfeiler-Leman hash: equal for isomorphic graphs, since it never looks at vertex numbers.
// Unequal graphs may share it (or collide), so it only chooses the bucket; isomorphism decides.
std::size_t bucket_of(const Graph& graph) {
  std::vector<std::size_t> colours;
  for (Vertex v = 0; v < boost::num_vertices(graph); ++v) colours.push_back(graph[v].colour);
  constexpr int rounds = 6;  // more changes no count, fewer only fills buckets more
  for (int round = 0; round < rounds; ++round) colours = refined(graph, colours);
  return hash_of_sorted(std::move(colours), 0);
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

void count_class(const Graph& graph, BruteForceCounts& counts) {
  std::vector<std::size_t> component(boost::num_vertices(graph));
  const std::size_t tendons = boost::connected_components(
      graph,
      boost::make_iterator_property_map(component.begin(), boost::get(boost::vertex_index, graph)));
  std::vector<bool> has_motor(tendons, false);
  for (Vertex v = 0; v < component.size(); ++v)
    if (graph[v].motor) has_motor[component[v]] = true;
  const bool actuated = std::find(has_motor.begin(), has_motor.end(), false) == has_motor.end();

  counts.all += 1;
  if (actuated) counts.actuated += 1;
  if (actuated && tendons == 1) counts.one_tendon += 1;
}

}  // namespace

BruteForceCounts brute_force_counts(const CountedParts& parts, int fingers,
                                    bool identical_fingers) {
  if (fingers < 1) throw std::invalid_argument("number of fingers is less than 1");
  const auto n = static_cast<std::size_t>(fingers);
  const PartKinds kinds = kinds_of(parts);
  const Palette palette(kinds, n, identical_fingers);

  BruteForceCounts counts;
  std::map<std::size_t, std::vector<Graph>> representatives;
  const Visitor visit = [&](const Assignment& assignment) {
    Graph graph = graph_of(assignment, palette);
    std::vector<Graph>& bucket = representatives[bucket_of(graph)];
    const auto is_known = [&](const Graph& known) {
      return same_routing(known, graph, palette.size());
    };
    if (std::any_of(bucket.begin(), bucket.end(), is_known)) return;
    count_class(graph, counts);
    bucket.push_back(std::move(graph));
  };
  Enumeration(kinds, n, visit).run();
  return counts;
}

}  // namespace reeve::testing
