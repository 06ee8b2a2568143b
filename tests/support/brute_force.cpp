#include "tests/support/brute_force.hpp"

#include <cstddef>
#include <functional>
#include <stdexcept>
#include <vector>

#include "tests/support/part_graph.hpp"

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

}  // namespace

BruteForceCounts brute_force_counts(const CountedParts& parts, int fingers,
                                    bool identical_fingers) {
  if (fingers < 1) throw std::invalid_argument("number of fingers is less than 1");
  const auto n = static_cast<std::size_t>(fingers);
  const PartKinds kinds = kinds_of(parts);
  const Palette palette(kinds, n, identical_fingers);

  GraphClasses classes(palette.size());
  const Visitor visit = [&](const Assignment& assignment) {
    classes.add(graph_of(assignment, palette));
  };
  Enumeration(kinds, n, visit).run();
  return classes.counts();
}

}  // namespace reeve::testing
