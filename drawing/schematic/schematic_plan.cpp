#include "drawing/schematic/schematic_plan.hpp"

#include <algorithm>
#include <cmath>

namespace reeve::drawing {
namespace {

class Planner {
 public:
  explicit Planner(const Network& network) : net_(network) {}

  SchematicPlan plan() {
    note_contacts();
    add_blocks();
    for (std::size_t block = 0; block < plan_.blocks.size(); ++block) add_columns(block);
    hang_motor_side();
    plan_.widened.assign(plan_.columns.size(), false);
    plan_.hand_arcs = arcs(ContactPlace::hand_join);
    plan_.carriage_arcs = arcs(ContactPlace::carriage);
    place_turns(plan_.hand_arcs, hand_reach());
    place_turns(plan_.carriage_arcs, carriage_reach());
    return std::move(plan_);
  }

 private:
  // How many rows of arcs a column's line passes before it ends.
  using Reach = std::vector<std::size_t>;

  void note_contacts() {
    plan_.segments.resize(net_.segments.size());
    for (std::size_t t = 0; t < net_.tendons.size(); ++t) {
      const TendonSpan& tendon = net_.tendons[t];
      for (std::size_t i = 0; i < tendon.segments; ++i) {
        plan_.segments[tendon.first_segment + i].tendon = t;
      }
      for (std::size_t k = 0; k < tendon.contacts; ++k) {
        const auto [left, right] = ends_of(tendon, k);
        plan_.segments[left].after = tendon.first_contact + k;
        plan_.segments[right].before = tendon.first_contact + k;
      }
    }
  }

  // The next strand along the walk from a segment, to one side; nowhere if the tendon ends first.
  std::size_t next_strand(std::size_t segment, bool forward) const {
    const TendonSpan& tendon = net_.tendons[plan_.segments[segment].tendon];
    for (std::size_t step = 1; step <= tendon.segments; ++step) {
      const std::size_t at = segment - tendon.first_segment;
      if (!tendon.closed && (forward ? at + step >= tendon.segments : step > at)) return nowhere;
      const std::size_t moved = forward ? at + step : at + tendon.segments - step;
      const std::size_t next = tendon.first_segment + moved % tendon.segments;
      if (net_.segments[next].kind == SegmentKind::strand) return next;
    }
    return nowhere;
  }

  // Where along the row of fingers a strand stands.
  double position(std::size_t strand) const {
    const Segment& segment = net_.segments[strand];
    return segment.finger + (is_right_strand(strand) ? 0.4 : -0.4);
  }

  bool is_joined(std::size_t contact) const {
    return contact != nowhere && net_.contacts[contact].place == ContactPlace::hand_join;
  }

  // The strands that a stretch at the hand should stand beside: those that joins lead to, since
  // lines run there through the hand; if there is no join, those behind its sheaths.
  std::array<std::size_t, 2> strands_near(std::size_t segment) const {
    const SegmentPlan& ends = plan_.segments[segment];
    const bool any = !is_joined(ends.before) && !is_joined(ends.after);
    return {any || is_joined(ends.before) ? next_strand(segment, false) : nowhere,
            any || is_joined(ends.after) ? next_strand(segment, true) : nowhere};
  }

  double key_of_stretch(std::size_t segment) const {
    const auto [before, after] = strands_near(segment);
    if (before == nowhere && after == nowhere) return net_.fingers + 1;
    if (before == nowhere) return position(after);
    if (after == nowhere) return position(before);
    return (position(before) + position(after)) / 2;
  }

  // Whether the end of a stretch should stand left of its begin.
  bool runs_left(std::size_t segment) const {
    const auto [before, after] = strands_near(segment);
    if (before == nowhere && after == nowhere) return false;
    if (before == nowhere) return is_right_strand(after);
    if (after == nowhere) return !is_right_strand(before);
    return position(before) > position(after);
  }

  bool is_right_strand(std::size_t strand) const { return net_.segments[strand].number % 2 == 0; }

  void add_blocks() {
    for (int finger = 1; finger <= net_.fingers; ++finger) {
      plan_.blocks.push_back({finger, 0, 0, static_cast<double>(finger), 0});
    }
    for (std::size_t i = 0; i < net_.segments.size(); ++i) {
      if (net_.segments[i].kind != SegmentKind::hand) continue;
      plan_.blocks.push_back({0, 0, 0, key_of_stretch(i), i});
    }
    std::stable_sort(plan_.blocks.begin(), plan_.blocks.end(),
                     [](const ColumnBlock& a, const ColumnBlock& b) { return a.key < b.key; });
  }

  void add_columns(std::size_t block) {
    ColumnBlock& added = plan_.blocks[block];
    added.first_column = plan_.columns.size();
    if (added.finger != 0) {
      for (const int number : {2 * added.finger - 1, 2 * added.finger}) {
        add_strand(block, number);
      }
    } else {
      add_stretch(block, added.segment);
    }
    added.columns = plan_.columns.size() - added.first_column;
  }

  void add_strand(std::size_t block, int number) {
    for (std::size_t i = 0; i < net_.segments.size(); ++i) {
      if (net_.segments[i].kind != SegmentKind::strand || net_.segments[i].number != number) {
        continue;
      }
      // The walk enters a finger by its odd strand, whose end is then the tip.
      add_column(block, i, number % 2 == 0);
    }
  }

  void add_stretch(std::size_t block, std::size_t segment) {
    const SegmentPlan& ends = plan_.segments[segment];
    const bool backwards = runs_left(segment);
    for (const bool end : {backwards, !backwards}) {
      if ((end ? ends.after : ends.before) != nowhere) add_column(block, segment, end);
    }
    const bool bare = ends.before == nowhere && ends.after == nowhere;
    if (bare) add_column(block, segment, false);
  }

  void add_column(std::size_t block, std::size_t segment, bool end) {
    SegmentPlan& ends = plan_.segments[segment];
    ends.column[end ? 1 : 0] = plan_.columns.size();
    Column column{block, segment, Foot::fixed, end ? ends.after : ends.before, nowhere};
    if (column.contact != nowhere) {
      const bool sheath = net_.contacts[column.contact].place == ContactPlace::sheath;
      column.foot = sheath ? Foot::sheath : Foot::joined;
    }
    plan_.columns.push_back(column);
  }

  void hang_motor_side() {
    for (std::size_t c = 0; c < plan_.columns.size(); ++c) {
      Column& column = plan_.columns[c];
      if (column.foot != Foot::sheath) continue;
      for (std::size_t i = 0; i < net_.segments.size(); ++i) {
        SegmentPlan& segment = plan_.segments[i];
        if (net_.segments[i].kind != SegmentKind::motor_side) continue;
        if (segment.before != column.contact && segment.after != column.contact) continue;
        column.motor_side = i;
        segment.column = {c, c};
      }
    }
  }

  std::vector<Arc> arcs(ContactPlace place) const {
    std::vector<Arc> found;
    for (const TendonSpan& tendon : net_.tendons) {
      for (std::size_t k = 0; k < tendon.contacts; ++k) {
        const std::size_t contact = tendon.first_contact + k;
        if (net_.contacts[contact].place != place) continue;
        const auto [left, right] = ends_of(tendon, k);
        const std::size_t from = plan_.segments[left].column[1];
        const std::size_t to = plan_.segments[right].column[0];
        found.push_back({contact, std::min(from, to), std::max(from, to), 0, 0, from < to});
      }
    }
    std::stable_sort(found.begin(), found.end(), [](const Arc& a, const Arc& b) {
      return a.right - a.left < b.right - b.left;
    });
    for (std::size_t i = 0; i < found.size(); ++i) {
      for (std::size_t above = 0; above < i; ++above) {
        const bool apart = found[above].right < found[i].left || found[i].right < found[above].left;
        if (!apart) found[i].row = std::max(found[i].row, found[above].row + 1);
      }
    }
    return found;
  }

  Reach hand_reach() const {
    Reach reach;
    for (const Column& column : plan_.columns) {
      reach.push_back(column.foot == Foot::sheath ? nowhere : 0);
    }
    return with_arcs(std::move(reach), plan_.hand_arcs);
  }

  Reach carriage_reach() const {
    return with_arcs(Reach(plan_.columns.size(), 0), plan_.carriage_arcs);
  }

  static Reach with_arcs(Reach reach, const std::vector<Arc>& arcs) {
    for (const Arc& arc : arcs) reach[arc.left] = reach[arc.right] = arc.row;
    return reach;
  }

  // The nearest gap to the arc's middle; rather one that no other line bounds.
  void place_turns(std::vector<Arc>& arcs, const Reach& reach) {
    for (Arc& arc : arcs) {
      arc.gap = arc.left;
      if (arc.right == arc.left + 1) continue;
      double least = std::numeric_limits<double>::infinity();
      for (std::size_t gap = arc.left; gap < arc.right; ++gap) {
        if (plan_.columns[gap].block == plan_.columns[gap + 1].block) continue;
        const double off =
            std::abs(static_cast<double>(2 * gap + 1) - static_cast<double>(arc.left + arc.right));
        const bool widens = must_widen(gap, arc, reach) && !plan_.widened[gap];
        const double cost = off + (widens ? 1000 : 0);
        if (cost >= least) continue;
        least = cost;
        arc.gap = gap;
      }
      if (must_widen(arc.gap, arc, reach)) plan_.widened[arc.gap] = true;
    }
  }

  static bool must_widen(std::size_t gap, const Arc& arc, const Reach& reach) {
    return (gap != arc.left && reach[gap] > arc.row) ||
           (gap + 1 != arc.right && reach[gap + 1] > arc.row);
  }

  const Network& net_;
  SchematicPlan plan_;
};

}  // namespace

SchematicPlan plan(const Network& network) { return Planner(network).plan(); }

std::size_t rows(const std::vector<Arc>& arcs) {
  std::size_t count = 0;
  for (const Arc& arc : arcs) count = std::max(count, arc.row + 1);
  return count;
}

}  // namespace reeve::drawing
