#include "tests/support/tree_brute_force.hpp"

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <vector>

#include "tests/support/part_graph.hpp"

namespace reeve::testing {
namespace {

enum class PortKind { strand, side, tail };

// What is tied at the hand: a strand's end, a side of a block's pass, a block's tail.
struct Port {
  PortKind kind;
  std::size_t owner;  // finger or block
};

constexpr std::size_t nothing = static_cast<std::size_t>(-1);

// A port that is its own partner has an end, `part` % ends, and two strands a join of the kind
// `part`. Partners of which one is a tail, and ends, touch, or have a join of the kind `part` - 1,
// or `part` / ends - 1, between them; all other partners touch.
struct Tie {
  std::size_t partner = nothing;
  std::size_t part = 0;
};

struct PortParts {
  std::size_t tips;  // the kind behind them is an anchored tip
  bool anchored;
  bool linked;
  std::size_t joins;  // passive ones first
  std::size_t passive_joins;
  std::size_t ends;  // motor ones first
  std::size_t motor_ends;
  std::size_t motors;  // for each kind on a carriage one kind after the other
  std::size_t beside;  // passive ones first
  std::size_t passive_beside;

  std::size_t fingers() const { return tips + (anchored ? 1 : 0); }
};

std::size_t many(int number) { return static_cast<std::size_t>(number); }

PortParts port_parts(const CountedTreeParts& counted) {
  const CountedParts& parts = counted.parts;
  return {many(parts.tube_like_tips),
          counted.anchored,
          counted.linked,
          many(parts.passive_joins + parts.motor_joins * counted.motors),
          many(parts.passive_joins),
          many(parts.motor_ends * counted.motors + parts.fixed_ends),
          many(parts.motor_ends * counted.motors),
          many(counted.motors),
          many(counted.passive_beside + counted.motor_beside * counted.motors),
          many(counted.passive_beside)};
}

class Search {
 public:
  Search(const PortParts& kinds, std::size_t fingers, std::size_t blocks, bool identical)
      : kinds_(kinds),
        blocks_(blocks),
        identical_(identical),
        tip_(fingers, 0),
        classes_(first_tip() + kinds.fingers() * fingers) {}

  const BruteForceCounts& run() {
    choose_tip(0);
    return classes_.counts();
  }

 private:
  // Of identical fingers the kinds may be taken to ascend.
  void choose_tip(std::size_t finger) {
    if (finger == tip_.size()) return tie_all();
    for (std::size_t kind = finger > 0 && identical_ ? tip_[finger - 1] : 0;
         kind < kinds_.fingers(); ++kind) {
      tip_[finger] = kind;
      choose_tip(finger + 1);
    }
  }

  bool is_anchored(std::size_t finger) const { return tip_[finger] == kinds_.tips; }

  void tie_all() {
    ports_.clear();
    for (std::size_t f = 0; f < tip_.size(); ++f) {
      ports_.push_back({PortKind::strand, f});
      if (!is_anchored(f)) ports_.push_back({PortKind::strand, f});
    }
    for (std::size_t b = 0; b < blocks_; ++b) {
      ports_.push_back({PortKind::side, b});
      ports_.push_back({PortKind::side, b});
      ports_.push_back({PortKind::tail, b});
    }
    ties_.assign(ports_.size(), {});
    tie(0);
  }

  void tie(std::size_t port) {
    if (port == ports_.size()) return add();
    if (ties_[port].partner != nothing) return tie(port + 1);
    for (std::size_t part = 0; part < kinds_.ends * (1 + kinds_.beside); ++part) {
      if (ports_[port].kind != PortKind::tail || hangs(part)) with(port, port, part);
    }
    for (std::size_t other = port + 1; other < ports_.size(); ++other) {
      if (ties_[other].partner != nothing || has_free_twin_before(port, other)) continue;
      const PortKind kind = ports_[port].kind;
      const std::size_t joins = ways_to_join(kind, ports_[other].kind);
      const bool must_join =
          kind == PortKind::tail && ports_[other].kind == PortKind::tail && !kinds_.linked;
      for (std::size_t join = must_join ? 1 : 0; join < joins; ++join) with(port, other, join);
    }
  }

  // Whether a tail by such an end is no fixed pulley.
  bool hangs(std::size_t part) const {
    const std::size_t variant = part / kinds_.ends;
    return part % kinds_.ends < kinds_.motor_ends || variant > kinds_.passive_beside;
  }

  void with(std::size_t port, std::size_t other, std::size_t part) {
    ties_[port] = {other, part};
    ties_[other] = {port, part};
    tie(port + 1);
    ties_[other] = {};
    ties_[port] = {};
  }

  std::size_t ways_to_join(PortKind a, PortKind b) const {
    if (a == PortKind::strand && b == PortKind::strand) return kinds_.joins;
    if (a == PortKind::tail || b == PortKind::tail) return 1 + kinds_.beside;
    return a == b ? 0 : 1;  // no two passes
  }

  bool is_free(std::size_t port, std::size_t current) const {
    return port != current && ties_[port].partner == nothing;
  }

  bool is_all_free(PortKind kind, std::size_t owner, std::size_t current) const {
    for (std::size_t p = 0; p < ports_.size(); ++p) {
      const bool of_block = (ports_[p].kind == PortKind::strand) == (kind == PortKind::strand);
      if (of_block && ports_[p].owner == owner && !is_free(p, current)) return false;
    }
    return true;
  }

  // The two strands of a finger, the sides of a pass, identical fingers and blocks are alike as
  // long as nothing is tied to them, so that the first of them stands for all. It saves time only.
  bool has_free_twin_before(std::size_t current, std::size_t port) const {
    const auto [kind, owner] = ports_[port];
    if (kind != PortKind::tail && ports_[port - 1].kind == kind &&
        ports_[port - 1].owner == owner && is_free(port - 1, current)) {
      return true;
    }
    const bool is_finger = kind == PortKind::strand;
    if (owner == 0 || (is_finger && (!identical_ || tip_[owner] != tip_[owner - 1]))) return false;
    return is_all_free(kind, owner, current) && is_all_free(kind, owner - 1, current);
  }

  // For each port the least one on its tendon: along fingers, joins and passes, not from a block's
  // tail to its pass.
  std::vector<std::size_t> tendons() const {
    std::vector<std::size_t> tendon(ports_.size());
    std::iota(tendon.begin(), tendon.end(), std::size_t{0});
    const auto unite = [&](std::size_t a, std::size_t b) {
      const std::size_t from = std::max(tendon[a], tendon[b]);
      const std::size_t to = std::min(tendon[a], tendon[b]);
      std::replace(tendon.begin(), tendon.end(), from, to);
    };
    for (std::size_t p = 0; p < ports_.size(); ++p) {
      unite(p, ties_[p].partner);
      if (p > 0 && ports_[p].kind != PortKind::tail && ports_[p].kind == ports_[p - 1].kind &&
          ports_[p].owner == ports_[p - 1].owner) {
        unite(p, p - 1);
      }
    }
    return tendon;
  }

  bool is_generated() const {
    const std::vector<std::size_t> tendon = tendons();
    std::vector<std::size_t> passes(ports_.size(), nothing);  // the block that a tendon passes
    for (std::size_t p = 0; p < ports_.size(); ++p) {
      if (ports_[p].kind != PortKind::side) continue;
      std::size_t& block = passes[tendon[p]];
      if (block != nothing && block != ports_[p].owner) return false;
      block = ports_[p].owner;
    }
    std::vector<bool> carries(blocks_, false);  // something but bare ends
    std::vector<std::size_t> above(blocks_, nothing);
    for (std::size_t p = 0; p < ports_.size(); ++p) {
      const std::size_t block = passes[tendon[p]];
      if (ports_[p].kind == PortKind::tail) above[ports_[p].owner] = block;
      if (ports_[p].kind != PortKind::side && block != nothing) carries[block] = true;
    }
    for (std::size_t b = 0; b < blocks_; ++b) {
      if (!carries[b]) return false;
      std::size_t top = b;
      for (std::size_t i = 0; i <= blocks_ && top != nothing; ++i) top = above[top];
      if (top != nothing) return false;  // it hangs on itself
    }
    return true;
  }

  // Colours: strand, side, tail, block, ends, joins, joins beside ends, carriages, tips.
  std::size_t first_join() const { return 4 + kinds_.ends; }
  std::size_t first_beside() const { return first_join() + kinds_.joins; }
  std::size_t first_carriage() const { return first_beside() + kinds_.beside; }
  std::size_t first_tip() const { return first_carriage() + kinds_.motors; }

  // Each motor that pulls something, by what is on its carriage. Identical ones have one colour.
  bool add_carriages(Graph& graph) const {
    std::vector<std::vector<Vertex>> moved(kinds_.motors);
    for (Vertex v = 0; v < boost::num_vertices(graph); ++v) {
      if (!graph[v].motor) continue;
      std::size_t& colour = graph[v].colour;
      const std::size_t first = colour < first_join()     ? 4
                                : colour < first_beside() ? first_join() + kinds_.passive_joins
                                                          : first_beside() + kinds_.passive_beside;
      const std::size_t motor = (colour - first) % kinds_.motors;
      colour -= motor;
      moved[motor].push_back(v);
    }
    for (std::size_t motor = 0; motor < kinds_.motors; ++motor) {
      if (moved[motor].empty() && kinds_.motors > 1) return false;
      const std::size_t colour = first_carriage() + (identical_ ? 0 : motor);
      const Vertex carriage = add_part({colour, false, true}, graph);
      for (const Vertex v : moved[motor]) boost::add_edge(carriage, v, graph);
    }
    return true;
  }

  void add() {
    if (!is_generated()) return;
    Graph graph;
    for (const Port& port : ports_) add_part({static_cast<std::size_t>(port.kind), false}, graph);
    std::vector<Vertex> blocks;
    for (std::size_t b = 0; b < blocks_; ++b) blocks.push_back(add_part({3, false}, graph));
    std::vector<Vertex> tips;
    for (std::size_t f = 0; f < tip_.size(); ++f) {
      tips.push_back(
          add_part({first_tip() + tip_[f] * tip_.size() + (identical_ ? 0 : f), false}, graph));
    }
    for (std::size_t p = 0; p < ports_.size(); ++p) {
      const bool of_finger = ports_[p].kind == PortKind::strand;
      boost::add_edge(p, (of_finger ? tips : blocks)[ports_[p].owner], graph);
      add_tie(p, graph);
    }
    if (add_carriages(graph)) classes_.add(std::move(graph));
  }

  void add_tie(std::size_t p, Graph& graph) const {
    const auto [partner, part] = ties_[p];
    if (partner < p) return;
    if (partner == p) {
      const std::size_t end = part % kinds_.ends;
      const Vertex tied = add_part({4 + end, end < kinds_.motor_ends}, graph);
      add_beside(p, tied, part / kinds_.ends, graph);
    } else if (ports_[p].kind == PortKind::strand && ports_[partner].kind == PortKind::strand) {
      const Vertex join = add_part({first_join() + part, part >= kinds_.passive_joins}, graph);
      boost::add_edge(p, join, graph);
      boost::add_edge(partner, join, graph);
    } else {
      add_beside(p, partner, part, graph);
    }
  }

  void add_beside(Vertex a, Vertex b, std::size_t variant, Graph& graph) const {
    if (variant > 0) {
      const std::size_t kind = variant - 1;
      const Vertex join = add_part({first_beside() + kind, kind >= kinds_.passive_beside}, graph);
      boost::add_edge(a, join, graph);
      a = join;
    }
    boost::add_edge(a, b, graph);
  }

  PortParts kinds_;
  std::size_t blocks_;
  bool identical_;
  std::vector<std::size_t> tip_;  // kinds, by finger
  std::vector<Port> ports_;
  std::vector<Tie> ties_;
  GraphClasses classes_;
};

}  // namespace

BruteForceCounts brute_force_trees(const CountedTreeParts& parts, int fingers, int blocks,
                                   bool identical_fingers) {
  return Search(port_parts(parts), many(fingers), many(blocks), identical_fingers).run();
}

}  // namespace reeve::testing
