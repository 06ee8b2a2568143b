#include "tests/support/brute_force.hpp"

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <vector>

#include "tests/support/part_graph.hpp"

namespace reeve::testing {
namespace {

enum class PortKind { strand, side, tail, becket };

// A port is tied at the hand: a strand's end, a side of a block's pass, a block's tail or becket.
struct Port {
  PortKind kind;
  std::size_t owner;     // finger or block
  std::size_t pass = 0;  // which of the block's

  friend bool operator==(const Port&, const Port&) = default;
};

struct Sheaves {
  std::size_t passes = 1;
  std::size_t beckets = 0;

  friend auto operator<=>(const Sheaves&, const Sheaves&) = default;
};

constexpr std::size_t untied = static_cast<std::size_t>(-1);

// A port that is its own partner has an end, `part` % ends, and two strands a join of the kind
// `part`. Partners of which one is a tail, and ends, touch, or have a join of the kind `part` - 1,
// or `part` / ends - 1, between them. Sides of two passes touch or have a join of the kind
// `part` - 1 between them; all other partners touch.
struct Tie {
  std::size_t partner = untied;
  std::size_t part = 0;
};

struct PortParts {
  std::size_t tips;  // the kind behind them is an anchored tip
  bool anchored;
  bool linked;
  bool series;
  bool barred;
  bool becketed;
  bool doubled;
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
          counted.series,
          counted.barred,
          counted.becketed,
          counted.doubled,
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
        sheaves_(blocks),
        classes_(first_tip() + kinds.fingers() * fingers) {}

  const RoutingCounts& run() {
    for (bars_ = 0; bars_ <= (kinds_.barred ? blocks_ : 0); ++bars_) choose_tip(0);
    return classes_.counts();
  }

 private:
  // Of identical fingers the kinds may be taken to ascend.
  void choose_tip(std::size_t finger) {
    if (finger == tip_.size()) return choose_sheaves(0);
    for (std::size_t kind = finger > 0 && identical_ ? tip_[finger - 1] : 0;
         kind < kinds_.fingers(); ++kind) {
      tip_[finger] = kind;
      choose_tip(finger + 1);
    }
  }

  // The sheaves of blocks may be taken to ascend; bars have none.
  void choose_sheaves(std::size_t block) {
    if (block == blocks_) return tie_all();
    sheaves_[block] = {};
    if (block < bars_) return choose_sheaves(block + 1);
    for (std::size_t passes = 1; passes <= (kinds_.doubled ? 2U : 1U); ++passes) {
      for (std::size_t beckets = 0; beckets <= (kinds_.becketed ? 2U : 0U); ++beckets) {
        sheaves_[block] = {passes, beckets};
        if (block > bars_ && sheaves_[block] < sheaves_[block - 1]) continue;
        choose_sheaves(block + 1);
      }
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
      for (std::size_t side = 0; side < 2 * sheaves_[b].passes; ++side) {
        ports_.push_back({PortKind::side, b, side / 2});
      }
      ports_.push_back({PortKind::tail, b});
      for (std::size_t i = 0; i < sheaves_[b].beckets; ++i)
        ports_.push_back({PortKind::becket, b, i});
    }
    ties_.assign(ports_.size(), {});
    tie(0);
  }

  void tie(std::size_t port) {
    if (port == ports_.size()) return add();
    if (ties_[port].partner != untied) return tie(port + 1);
    for (std::size_t part = 0; part < kinds_.ends * (1 + kinds_.beside); ++part) {
      if (may_have_end(ports_[port], part)) with(port, port, part);
    }
    for (std::size_t other = port + 1; other < ports_.size(); ++other) {
      if (ties_[other].partner != untied || has_free_twin_before(port, other)) continue;
      const std::size_t joins = ways_to_join(ports_[port], ports_[other]);
      const bool must_join = are_both(PortKind::tail, port, other) && !kinds_.linked;
      for (std::size_t join = must_join ? 1 : 0; join < joins; ++join) with(port, other, join);
    }
  }

  // A block's tail by a passive end would be a fixed pulley, and by a becket a tendon holds on.
  bool may_have_end(const Port& port, std::size_t part) const {
    if (port.kind != PortKind::tail) return port.kind != PortKind::becket;
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

  bool are_both(PortKind kind, std::size_t a, std::size_t b) const {
    return ports_[a].kind == kind && ports_[b].kind == kind;
  }

  std::size_t ways_to_join(const Port& a, const Port& b) const {
    if (a.kind == PortKind::strand && b.kind == PortKind::strand) return kinds_.joins;
    if (a.kind == PortKind::becket) return 0;
    if (b.kind == PortKind::becket) return a.kind == PortKind::strand ? 1 : 0;
    if (a.kind == PortKind::tail || b.kind == PortKind::tail) return 1 + kinds_.beside;
    if (a.kind != b.kind) return 1;
    return kinds_.series && a.owner != b.owner ? 1 + kinds_.joins : 0;  // of two passes
  }

  // True of the second of two strands of a finger, or sides of a pass.
  bool is_second(std::size_t port) const {
    return port > 0 && ports_[port].kind != PortKind::tail && ports_[port] == ports_[port - 1];
  }

  bool is_free(std::size_t port, std::size_t current) const {
    return port != current && ties_[port].partner == untied;
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
    const auto [kind, owner, pass] = ports_[port];
    if (is_second(port) && is_free(port - 1, current)) return true;
    const bool is_finger = kind == PortKind::strand;
    if (!is_finger && owner == bars_) return false;
    if (!is_finger && owner > 0 && sheaves_[owner] != sheaves_[owner - 1]) return false;
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
      if (is_second(p)) unite(p, p - 1);
    }
    return tendon;
  }

  // Passes[t] holds the blocks that tendon t passes.
  using Passes = std::vector<std::vector<std::size_t>>;

  bool is_generated() const {
    const std::vector<std::size_t> tendon = tendons();
    Passes passes(ports_.size());  // by tendon
    std::vector<std::size_t> above(blocks_);
    for (std::size_t p = 0; p < ports_.size(); ++p) {
      const auto [kind, owner, pass] = ports_[p];
      if (kind == PortKind::tail) above[owner] = tendon[p];
      if (kind == PortKind::side && !is_second(p)) passes[tendon[p]].push_back(owner);
    }
    for (std::size_t t = 0; t < ports_.size() && (kinds_.becketed || kinds_.doubled); ++t) {
      if (!are_sheaves_in_order(t, tendon, passes[t])) return false;
    }
    std::vector<std::size_t> tree(ports_.size());  // by tendon
    std::iota(tree.begin(), tree.end(), std::size_t{0});
    std::vector<std::size_t> roots_in_series;
    for (std::size_t t = 0; t < ports_.size(); ++t) {
      for (const std::size_t block : passes[t]) {
        const std::size_t from = tree[t];
        if (from == tree[above[block]]) return false;  // it hangs on itself, or twice
        std::replace(tree.begin(), tree.end(), from, tree[above[block]]);
      }
      if (passes[t].size() == 1 && !carries_more_than_ends(t, tendon)) return false;
      if (passes[t].size() < 2) continue;
      if (!kinds_.series || !is_root_in_series(t, tendon, passes, above)) return false;
      if (std::any_of(passes[t].begin(), passes[t].end(), [&](auto b) { return b < bars_; })) {
        return false;
      }
      roots_in_series.push_back(t);
    }
    std::vector<std::size_t> of_trees;
    for (const std::size_t root : roots_in_series) of_trees.push_back(tree[root]);
    std::sort(of_trees.begin(), of_trees.end());
    return std::adjacent_find(of_trees.begin(), of_trees.end()) == of_trees.end();
  }

  // A becket holds a tendon that passes its block. Of a block that is passed twice both passes are
  // on one open tendon, which is more than ends on one side at least. Each block is left once.
  bool are_sheaves_in_order(std::size_t t, const std::vector<std::size_t>& tendon,
                            std::vector<std::size_t>& passed) const {
    std::size_t ends = 0;
    std::vector<std::size_t> bare_sides(blocks_, 0);
    for (std::size_t p = 0; p < ports_.size(); ++p) {
      if (tendon[p] != t) continue;
      const auto [kind, owner, pass] = ports_[p];
      if (kind == PortKind::becket && std::count(passed.begin(), passed.end(), owner) == 0) {
        return false;
      }
      const bool is_end = ties_[p].partner == p;
      if (is_end || kind == PortKind::becket || kind == PortKind::tail ||
          (kind == PortKind::strand && is_anchored(owner))) {
        ++ends;
      }
      if (kind == PortKind::side && is_end) ++bare_sides[owner];
    }
    std::sort(passed.begin(), passed.end());
    const std::size_t all = passed.size();
    passed.erase(std::unique(passed.begin(), passed.end()), passed.end());
    std::size_t expected = 0;
    for (const std::size_t block : passed) expected += sheaves_[block].passes;
    if (all != expected) return false;
    if (all == passed.size()) return true;
    return passed.size() == 1 && ends == 2 && bare_sides[passed[0]] < 2;
  }

  bool carries_more_than_ends(std::size_t t, const std::vector<std::size_t>& tendon) const {
    for (std::size_t p = 0; p < ports_.size(); ++p) {
      if (tendon[p] == t && ports_[p].kind != PortKind::side) return true;
    }
    return false;
  }

  // Open, its passes side by side, each block on a tendon that passes none and is more than an end.
  bool is_root_in_series(std::size_t t, const std::vector<std::size_t>& tendon,
                         const Passes& passes, const std::vector<std::size_t>& above) const {
    std::size_t ends = 0;
    std::size_t side_by_side = 0;
    for (std::size_t p = 0; p < ports_.size(); ++p) {
      const auto [kind, owner, pass] = ports_[p];
      const std::size_t partner = ties_[p].partner;
      if (kind == PortKind::tail && partner == p &&
          std::count(passes[t].begin(), passes[t].end(), owner) > 0) {
        return false;
      }
      if (tendon[p] != t) continue;
      const bool is_anchor = kind == PortKind::strand && is_anchored(owner);
      if (partner == p || is_anchor || kind == PortKind::tail) ++ends;
      if (partner > p && are_both(PortKind::side, p, partner)) ++side_by_side;
    }
    return ends == 2 && side_by_side + 1 == passes[t].size() &&
           std::all_of(passes[t].begin(), passes[t].end(),
                       [&](std::size_t block) { return passes[above[block]].empty(); });
  }

  // Colours: strand, side, tail, becket, block, ends, joins, joins beside ends, carriages, tips. A
  // bar's tail has the block's colour.
  static constexpr std::size_t block_colour = 4;
  static constexpr std::size_t first_end = 5;
  std::size_t first_join() const { return first_end + kinds_.ends; }
  std::size_t first_beside() const { return first_join() + kinds_.joins; }
  std::size_t first_carriage() const { return first_beside() + kinds_.beside; }
  std::size_t first_tip() const { return first_carriage() + kinds_.motors; }

  // Each motor that pulls something, by what is on its carriage. Identical ones have one colour.
  bool add_carriages(Graph& graph) const {
    std::vector<std::vector<Vertex>> moved(kinds_.motors);
    for (Vertex v = 0; v < boost::num_vertices(graph); ++v) {
      if (!graph[v].motor) continue;
      std::size_t& colour = graph[v].colour;
      const std::size_t first = colour < first_join()     ? first_end
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
    for (const Port& port : ports_) {
      const bool is_pivot = port.kind == PortKind::tail && port.owner < bars_;
      add_part({is_pivot ? block_colour : static_cast<std::size_t>(port.kind), false}, graph);
    }
    std::vector<Vertex> blocks;
    for (std::size_t b = 0; b < blocks_; ++b)
      blocks.push_back(add_part({block_colour, false}, graph));
    std::vector<Vertex> tips;
    for (std::size_t f = 0; f < tip_.size(); ++f) {
      tips.push_back(
          add_part({first_tip() + tip_[f] * tip_.size() + (identical_ ? 0 : f), false}, graph));
    }
    for (std::size_t p = 0; p < ports_.size(); ++p) {
      const bool of_finger = ports_[p].kind == PortKind::strand;
      boost::add_edge(p, (of_finger ? tips : blocks)[ports_[p].owner], graph);
      if (!of_finger && is_second(p)) boost::add_edge(p, p - 1, graph);
      add_tie(p, graph);
    }
    if (add_carriages(graph)) classes_.add(std::move(graph));
  }

  void add_tie(std::size_t p, Graph& graph) const {
    const auto [partner, part] = ties_[p];
    if (partner < p) return;
    if (partner == p) {
      const std::size_t end = part % kinds_.ends;
      const Vertex tied = add_part({first_end + end, end < kinds_.motor_ends}, graph);
      add_beside(p, tied, part / kinds_.ends, graph);
    } else if (are_both(PortKind::strand, p, partner)) {
      add_join(p, partner, part, graph);
    } else if (are_both(PortKind::side, p, partner) && part > 0) {
      add_join(p, partner, part - 1, graph);
    } else {
      add_beside(p, partner, part, graph);
    }
  }

  void add_join(Vertex a, Vertex b, std::size_t kind, Graph& graph) const {
    const Vertex join = add_part({first_join() + kind, kind >= kinds_.passive_joins}, graph);
    boost::add_edge(a, join, graph);
    boost::add_edge(b, join, graph);
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
  std::size_t bars_ = 0;  // the first blocks
  bool identical_;
  std::vector<std::size_t> tip_;  // kinds, by finger
  std::vector<Sheaves> sheaves_;  // by block
  std::vector<Port> ports_;
  std::vector<Tie> ties_;
  GraphClasses classes_;
};

}  // namespace

RoutingCounts brute_force_trees(const CountedTreeParts& parts, int fingers, int blocks,
                                bool identical_fingers) {
  return Search(port_parts(parts), many(fingers), many(blocks), identical_fingers).run();
}

}  // namespace reeve::testing
