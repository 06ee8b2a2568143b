// Directions that blocks and joins face, and their levels below the fingers.
//
// A line that leaves one port downward and arrives at a lower one from above runs straight on. Two
// ports that face the same way need a bend. Blocks and joins are turned so that bends are few:
// blocks with fingers only lie nearest to the fingers, upright, and those above them nearer to the
// sheaths. A block whose tail pulls at a finger is inverted, with its tackle below.
#include <algorithm>

#include "drawing/schematic/fittings.hpp"

namespace reeve::drawing {
namespace {

class Facing {
 public:
  explicit Facing(Fittings& all) : all_(all) {}

  // Each turn saves a bend, so that this ends.
  void turn() {
    for (bool improved = true; improved;) {
      improved = false;
      for (std::size_t i = 0; i < all_.fittings.size(); ++i) {
        if (!can_turn(i) || gain(i) <= 0) continue;
        all_.fittings[i].inverted = !all_.fittings[i].inverted;
        improved = true;
      }
    }
  }

 private:
  bool can_turn(std::size_t fitting) const {
    const FittingKind kind = all_.fittings[fitting].kind;
    return kind == FittingKind::block || kind == FittingKind::join;
  }

  // Bends saved if it were turned over.
  int gain(std::size_t fitting) const {
    int gain = 0;
    for (const SegmentEnds& segment : all_.segments) {
      const auto [one, other] = segment.port;
      if (one == nowhere || other == nowhere) continue;
      const bool from_here = all_.ports[one].fitting == fitting;
      if (from_here == (all_.ports[other].fitting == fitting)) continue;
      gain += all_.faces_down(one) == all_.faces_down(other) ? 1 : -1;
    }
    return gain;
  }

  Fittings& all_;
};

// Longest paths downward; a step that would come back to where it began is left out.
class Levels {
 public:
  explicit Levels(Fittings& all) : all_(all), below_(all.fittings.size()) {
    for (const SegmentEnds& segment : all_.segments) {
      const auto [one, other] = segment.port;
      if (one == nowhere || other == nowhere) continue;
      if (all_.faces_down(one) == all_.faces_down(other)) continue;
      const bool forward = all_.faces_down(one);
      const std::size_t upper = all_.ports[forward ? one : other].fitting;
      const std::size_t lower = all_.ports[forward ? other : one].fitting;
      if (in_palm(lower)) below_[upper].push_back(lower);
    }
  }

  void set() {
    mark_.assign(all_.fittings.size(), Mark::none);
    for (std::size_t i = 0; i < all_.fittings.size(); ++i) visit(i);
    std::ranges::reverse(order_);
    std::size_t deepest = 0;
    for (const std::size_t upper : order_) {
      Fitting& fitting = all_.fittings[upper];
      if (in_palm(upper)) fitting.level = std::max<std::size_t>(fitting.level, 1);
      for (const std::size_t lower : below_[upper]) {
        std::size_t& level = all_.fittings[lower].level;
        level = std::max(level, fitting.level + 1);
      }
      deepest = std::max(deepest, fitting.level);
    }
    all_.sheath_level = deepest + 1;
    for (Fitting& fitting : all_.fittings) {
      if (fitting.kind == FittingKind::sheath) fitting.level = all_.sheath_level;
      if (fitting.kind == FittingKind::pulley) fitting.level = all_.sheath_level + 1;
    }
  }

 private:
  enum class Mark : std::uint8_t { none, open, closed };

  bool in_palm(std::size_t fitting) const {
    const FittingKind kind = all_.fittings[fitting].kind;
    return kind == FittingKind::block || kind == FittingKind::join || kind == FittingKind::clamp;
  }

  void visit(std::size_t fitting) {
    if (mark_[fitting] != Mark::none) return;
    mark_[fitting] = Mark::open;
    std::vector<std::size_t> kept;
    for (const std::size_t lower : below_[fitting]) {
      if (mark_[lower] == Mark::open) continue;
      kept.push_back(lower);
      visit(lower);
    }
    below_[fitting] = kept;
    mark_[fitting] = Mark::closed;
    order_.push_back(fitting);
  }

  Fittings& all_;
  std::vector<std::vector<std::size_t>> below_;
  std::vector<Mark> mark_;
  std::vector<std::size_t> order_;
};

void hang_sheaths(Fittings& all) {
  for (const SegmentEnds& segment : all.segments) {
    for (const std::size_t side : {0U, 1U}) {
      const std::size_t port = segment.port[side];
      const std::size_t other = segment.port[1 - side];
      if (port == nowhere || other == nowhere) continue;
      if (all.ports[port].role != PortRole::hand_side || !all.faces_down(other)) continue;
      all.fittings[all.ports[port].fitting].carrier = other;
    }
  }
}

void add_bends(Fittings& all) {
  for (SegmentEnds& segment : all.segments) {
    const auto [one, other] = segment.port;
    if (one == nowhere || other == nowhere) continue;
    if (all.faces_down(one) == all.faces_down(other)) continue;
    const bool forward = all.faces_down(one);
    if (all.of(forward ? one : other).level < all.of(forward ? other : one).level) continue;
    segment.via = all.ports.size();
    Fitting bend;
    bend.kind = FittingKind::bend;
    bend.ports.push_back(segment.via);
    all.ports.push_back({all.fittings.size(), PortRole::bend});
    all.fittings.push_back(bend);
  }
}

// Notes fittings that join the two strands of one finger and nothing else.
void note_inside(Fittings& all) {
  for (std::size_t i = 0; i < all.fittings.size(); ++i) {
    Fitting& fitting = all.fittings[i];
    if (fitting.inverted) continue;
    std::vector<std::size_t> above;
    std::size_t turns = 0;
    for (const SegmentEnds& segment : all.segments) {
      for (const std::size_t side : {0U, 1U}) {
        const std::size_t port = segment.port[side];
        const std::size_t other = segment.port[1 - side];
        if (port == nowhere || all.ports[port].fitting != i) continue;
        const PortRole role = all.ports[port].role;
        if (is_tail(role)) continue;
        ++turns;
        if (role != PortRole::turn || other == nowhere) continue;
        const std::size_t carrier = all.of(other).carrier;
        const std::size_t strand = carrier == nowhere ? other : carrier;
        if (all.of(strand).kind == FittingKind::finger) above.push_back(all.ports[strand].fitting);
      }
    }
    const bool one_finger = turns == 2 && above.size() == 2 && above[0] == above[1];
    fitting.inside = one_finger ? above[0] : nowhere;
  }
}

}  // namespace

void face(Fittings& all) {
  Facing(all).turn();
  Levels(all).set();
  hang_sheaths(all);
  add_bends(all);
  note_inside(all);
}

}  // namespace reeve::drawing
