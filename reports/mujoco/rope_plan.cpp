#include "reports/mujoco/rope_plan.hpp"

#include <fmt/format.h>

#include <iterator>
#include <utility>

#include "core/text.hpp"

namespace reeve::reports {
namespace {

class RopePlanner {
 public:
  explicit RopePlanner(const Network& network) : network_(network) {}

  void add(const Tendon& tendon, const TendonSpan& span) {
    std::vector<Rope> pieces = led(tendon, span);
    share_segments(span, pieces);
    if (tendon.closed) close(pieces);
    std::move(pieces.begin(), pieces.end(), std::back_inserter(plan_.ropes));
  }

  RopePlan take() { return std::move(plan_); }

 private:
  std::vector<Rope> led(const Tendon& tendon, const TendonSpan& span) {
    std::vector<Rope> pieces(1);
    for (std::size_t k = 0; k < tendon.walk.size(); ++k) {
      const Token& token = tendon.walk[k];
      if (is_end(token.kind)) {
        const std::size_t last = span.first_segment + span.segments - 1;
        add_end(token, network_.segments[k == 0 ? span.first_segment : last], k == 0,
                pieces.back());
      } else {
        add_inside(token, pieces);
      }
    }
    return pieces;
  }

  void add_end(const Token& token, const Segment& segment, bool is_first, Rope& rope) {
    if (token.kind == TokenKind::fixed_end) {
      rope.points.push_back(fixed());
    } else if (is_first) {
      leave(leg_of_end(token, segment), rope);
    } else {
      reach(leg_of_end(token, segment), rope);
    }
  }

  void add_inside(const Token& token, std::vector<Rope>& pieces) {
    if (token.kind == TokenKind::tube_join || token.kind == TokenKind::bearing_join) {
      pieces.back().points.push_back(fixed());
      return;
    }
    const bool is_bar = token.kind == TokenKind::bar_arms;
    reach(is_bar ? block_leg(token, Mover::left_arm) : leg_inside(token, 1), pieces.back());
    if (is_bar) pieces.emplace_back();
    leave(is_bar ? block_leg(token, Mover::right_arm) : leg_inside(token, 2), pieces.back());
  }

  std::size_t leg_of_end(const Token& token, const Segment& segment) {
    if (token.kind == TokenKind::motor_end) return carriage_leg(token);
    if (token.kind == TokenKind::anchored_tip) return strand_leg(segment);
    return block_leg(token, Mover::block);
  }

  std::size_t leg_inside(const Token& token, int side) {
    if (token.kind == TokenKind::finger) {
      return strand_leg({SegmentKind::strand, 2 * token.finger - 2 + side, token.finger});
    }
    if (token.kind == TokenKind::movable_pulley) return carriage_leg(token);
    return block_leg(token, Mover::block);
  }

  std::size_t strand_leg(const Segment& strand) {
    return added({Mover::runner, static_cast<std::size_t>(strand.finger), segment_name(strand),
                  strand.extensor});
  }

  std::size_t carriage_leg(const Token& token) {
    return added(
        {Mover::carriage, token.carriage, segment_name({SegmentKind::motor_side, ++motor_sides_})});
  }

  std::size_t block_leg(const Token& token, Mover mover) {
    std::size_t block = 0;
    while (network_.blocks[block].is_bar != is_of_bar(token.kind) ||
           network_.blocks[block].number != token.block) {
      ++block;
    }
    std::size_t number = 1;
    for (const Leg& leg : plan_.legs) {
      if (leg.mover >= Mover::block && leg.owner == block) ++number;
    }
    return added({mover, block, fmt::format("{}_{}", block_name(network_.blocks[block]), number),
                  is_tail(token.kind)});
  }

  std::size_t added(Leg leg) {
    plan_.legs.push_back(std::move(leg));
    return plan_.legs.size() - 1;
  }

  RopePoint fixed() { return {PointKind::fixed, plan_.fixed_points++}; }

  static void reach(std::size_t leg, Rope& rope) {
    rope.points.push_back({PointKind::eyelet, leg});
    rope.points.push_back({PointKind::mover, leg});
  }

  static void leave(std::size_t leg, Rope& rope) {
    rope.points.push_back({PointKind::mover, leg});
    rope.points.push_back({PointKind::eyelet, leg});
  }

  void share_segments(const TendonSpan& span, std::vector<Rope>& pieces) const {
    std::size_t piece = 0;
    for (std::size_t k = 0; k < span.segments; ++k) {
      pieces[piece].segments.push_back(span.first_segment + k);
      const bool parts =
          k < span.contacts && network_.contacts[span.first_contact + k].kind == ContactKind::bar;
      if (parts && piece + 1 < pieces.size()) ++piece;
    }
  }

  // A loop without bars comes back to its first point; with bars, its last piece goes on in the
  // first.
  static void close(std::vector<Rope>& pieces) {
    if (pieces.size() == 1) {
      pieces.front().points.push_back(pieces.front().points.front());
      return;
    }
    Rope last = std::move(pieces.back());
    pieces.pop_back();
    Rope& first = pieces.front();
    first.points.insert(first.points.begin(), last.points.begin(), last.points.end());
    first.segments.insert(first.segments.begin(), last.segments.begin(), last.segments.end());
  }

  const Network& network_;
  RopePlan plan_;
  int motor_sides_ = 0;
};

}  // namespace

RopePlan rope_plan(const Routing& routing, const Network& network) {
  RopePlanner planner(network);
  for (std::size_t t = 0; t < routing.tendons.size(); ++t) {
    planner.add(routing.tendons[t], network.tendons[t]);
  }
  return planner.take();
}

}  // namespace reeve::reports
