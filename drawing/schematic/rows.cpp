// The layout of a hand without floating parts.
//
// Every end of tendon that hangs down at the hand is a column. A finger is a block of two columns,
// its strands; a stretch at the hand (h1, …), which has no finger to run along, is a block of its
// own, with one column for each of its ends that leads to a contact. At its foot a column is fixed,
// joined to another column, or passes a sheath to the carriage.
//
// A join of two columns is an arc. Arcs that would lie over each other get rows of their own, the
// shorter ones on top, so that lines cross at right angles only. The turn itself, a tube or a
// wheel, sits in a gap between two neighbouring columns, where no other line runs.
#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "drawing/schematic/places.hpp"

namespace reeve::drawing {
namespace {

using namespace measures;

struct ColumnBlock {
  int finger = 0;           // 0: a stretch at the hand
  double key = 0;           // blocks stand in this order
  std::size_t segment = 0;  // segment of a stretch at the hand
  std::size_t first = 0;    // first of its columns
  std::size_t columns = 0;
};

struct Column {
  std::size_t block = 0;
  std::size_t port = nowhere;  // port at its foot; none if it is fixed there
  double x = 0;
};

// A turn that joins two columns, at the hand or on the carriage.
struct Arc {
  std::size_t left_port = 0;
  std::size_t right_port = 0;
  std::size_t left = 0;  // columns
  std::size_t right = 0;
  std::size_t row = 0;  // 0: the topmost
  std::size_t gap = 0;  // the turn sits between this column and the next
  double centre = 0;    // x of the turn's centre
  double radius = 0;
};

class RowPlacement {
 public:
  RowPlacement(const Network& network, Fittings fittings)
      : net_(network),
        out_(std::move(fittings)),
        all_(out_.fittings),
        column_at_(all_.ports.size(), nowhere),
        columns_of_(all_.segments.size(), {nowhere, nowhere}),
        lanes_(all_.ports.size(), 0) {}

  Places place() {
    add_blocks();
    for (std::size_t block = 0; block < blocks_.size(); ++block) add_columns(block);
    widened_.assign(columns_.size(), false);
    hand_arcs_ = arcs(FittingKind::join);
    carriage_arcs_ = arcs(FittingKind::pulley);
    place_turns(hand_arcs_, hand_reach());
    place_turns(carriage_arcs_, with_arcs(Reach(columns_.size(), 0), carriage_arcs_));
    place_columns();
    place_hand();
    place_motor_side();
    for (std::size_t i = 0; i < net_.segments.size(); ++i) add_pieces(i);
    return std::move(out_);
  }

 private:
  // [column]: number of rows of arcs that its line passes before it ends
  using Reach = std::vector<std::size_t>;

  SegmentKind kind(std::size_t segment) const { return net_.segments[segment].kind; }

  // The next strand along the walk from a segment, to one side; nowhere if the tendon ends first.
  std::size_t next_strand(std::size_t segment, bool forward) const {
    const TendonSpan& tendon = net_.tendons[all_.segments[segment].tendon];
    for (std::size_t step = 1; step <= tendon.segments; ++step) {
      const std::size_t at = segment - tendon.first_segment;
      if (!tendon.closed && (forward ? at + step >= tendon.segments : step > at)) return nowhere;
      const std::size_t moved = forward ? at + step : at + tendon.segments - step;
      const std::size_t next = tendon.first_segment + moved % tendon.segments;
      if (kind(next) == SegmentKind::strand) return next;
    }
    return nowhere;
  }

  bool is_right_strand(std::size_t strand) const { return net_.segments[strand].number % 2 == 0; }

  // Position of a strand along the row of fingers.
  double position(std::size_t strand) const {
    return net_.segments[strand].finger + (is_right_strand(strand) ? 0.4 : -0.4);
  }

  // The strands that a stretch at the hand should stand beside: those that joins lead to, since
  // lines run there through the hand; if there is no join, those behind its sheaths.
  std::array<std::size_t, 2> strands_near(std::size_t segment) const {
    const auto is_joined = [&](std::size_t port) {
      return port != nowhere && all_.of(port).kind == FittingKind::join;
    };
    const auto [begin, end] = all_.segments[segment].port;
    const bool any = !is_joined(begin) && !is_joined(end);
    return {any || is_joined(begin) ? next_strand(segment, false) : nowhere,
            any || is_joined(end) ? next_strand(segment, true) : nowhere};
  }

  double key_of_stretch(std::size_t segment) const {
    const auto [before, after] = strands_near(segment);
    if (before == nowhere && after == nowhere) return net_.fingers + 1;
    if (before == nowhere) return position(after);
    if (after == nowhere) return position(before);
    return (position(before) + position(after)) / 2;
  }

  // True if the end of a stretch should stand left of its begin.
  bool runs_left(std::size_t segment) const {
    const auto [before, after] = strands_near(segment);
    if (before == nowhere && after == nowhere) return false;
    if (before == nowhere) return is_right_strand(after);
    if (after == nowhere) return !is_right_strand(before);
    return position(before) > position(after);
  }

  void add_blocks() {
    for (int finger = 1; finger <= net_.fingers; ++finger) {
      blocks_.push_back({finger, static_cast<double>(finger)});
    }
    for (std::size_t i = 0; i < net_.segments.size(); ++i) {
      if (kind(i) == SegmentKind::hand) blocks_.push_back({0, key_of_stretch(i), i});
    }
    std::ranges::stable_sort(blocks_, {}, &ColumnBlock::key);
  }

  void add_columns(std::size_t block) {
    ColumnBlock& added = blocks_[block];
    added.first = columns_.size();
    if (added.finger == 0) {
      add_stretch(block, added.segment);
    } else {
      add_strand(block, 2 * added.finger - 1);
      add_strand(block, 2 * added.finger);
    }
    added.columns = columns_.size() - added.first;
  }

  void add_strand(std::size_t block, int number) {
    for (std::size_t i = 0; i < net_.segments.size(); ++i) {
      if (kind(i) != SegmentKind::strand || net_.segments[i].number != number) continue;
      // The walk enters a finger by its odd strand, whose end is then the tip.
      add_column(block, i, number % 2 == 0 ? 1 : 0);
    }
  }

  void add_stretch(std::size_t block, std::size_t segment) {
    const std::size_t first = runs_left(segment) ? 1 : 0;
    for (const std::size_t side : {first, 1 - first}) {
      const std::size_t port = all_.segments[segment].port[side];
      const bool clamped = port != nowhere && all_.ports[port].role == PortRole::clamp;
      if (clamped) add_column(block, segment, 1 - side);
      if (port != nowhere && !clamped) add_column(block, segment, side);
    }
  }

  void add_column(std::size_t block, std::size_t segment, std::size_t side) {
    const std::size_t port = all_.segments[segment].port[side];
    const std::size_t column = columns_.size();
    columns_.push_back({block, port});
    columns_of_[segment][side] = column;
    if (port == nowhere) return;
    column_at_[port] = column;
    if (all_.ports[port].role == PortRole::hand_side) add_motor_side(all_.ports[port].twin, column);
  }

  // Adds everything that hangs on a sheath, as far as the carriage.
  void add_motor_side(std::size_t port, std::size_t column) {
    column_at_[port] = column;
    for (std::size_t i = 0; i < all_.segments.size(); ++i) {
      const auto [begin, end] = all_.segments[i].port;
      if (begin != port && end != port) continue;
      columns_of_[i] = {column, column};
      const std::size_t other = begin == port ? end : begin;
      if (other != nowhere) column_at_[other] = column;
    }
  }

  std::vector<Arc> arcs(FittingKind kind) const {
    std::vector<Arc> found;
    for (const Fitting& fitting : all_.fittings) {
      if (fitting.kind != kind) continue;
      Arc arc{fitting.ports[0], fitting.ports[1]};
      if (column_at_[arc.left_port] > column_at_[arc.right_port]) {
        std::swap(arc.left_port, arc.right_port);
      }
      arc.left = column_at_[arc.left_port];
      arc.right = column_at_[arc.right_port];
      found.push_back(arc);
    }
    std::ranges::stable_sort(found, {}, [](const Arc& arc) { return arc.right - arc.left; });
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
    for (const Column& column : columns_) reach.push_back(passes_sheath(column) ? nowhere : 0);
    return with_arcs(std::move(reach), hand_arcs_);
  }

  bool passes_sheath(const Column& column) const {
    return column.port != nowhere && all_.ports[column.port].role == PortRole::hand_side;
  }

  static Reach with_arcs(Reach reach, const std::vector<Arc>& arcs) {
    for (const Arc& arc : arcs) reach[arc.left] = reach[arc.right] = arc.row;
    return reach;
  }

  bool in_one_block(std::size_t gap) const {
    return columns_[gap].block == columns_[gap + 1].block;
  }

  // The nearest gap to the arc's middle; rather one that no other line bounds.
  void place_turns(std::vector<Arc>& arcs, const Reach& reach) {
    for (Arc& arc : arcs) {
      arc.gap = arc.left;
      if (arc.right == arc.left + 1) continue;
      double least = std::numeric_limits<double>::infinity();
      for (std::size_t gap = arc.left; gap < arc.right; ++gap) {
        if (in_one_block(gap)) continue;
        const double off =
            std::abs(static_cast<double>(2 * gap + 1) - static_cast<double>(arc.left + arc.right));
        const bool widens = must_widen(gap, arc, reach) && !widened_[gap];
        const double cost = off + (widens ? 1000 : 0);
        if (cost >= least) continue;
        least = cost;
        arc.gap = gap;
      }
      if (must_widen(arc.gap, arc, reach)) widened_[arc.gap] = true;
    }
  }

  static bool must_widen(std::size_t gap, const Arc& arc, const Reach& reach) {
    return (gap != arc.left && reach[gap] > arc.row) ||
           (gap + 1 != arc.right && reach[gap + 1] > arc.row);
  }

  void place_columns() {
    double x = 0;
    for (const ColumnBlock& block : blocks_) {
      for (std::size_t i = 0; i < block.columns; ++i) {
        columns_[block.first + i].x = x + pitch * static_cast<double>(i);
      }
      if (block.finger != 0) out_.fingers.push_back(x + pitch / 2);
      const bool widened = widened_[block.first + block.columns - 1];
      out_.width = x + pitch;
      x = out_.width + (widened ? widened_gap : block_gap);
    }
    for (std::size_t port = 0; port < all_.ports.size(); ++port) {
      const FittingPort& at = all_.ports[port];
      const double side = at.offset;
      if (at.role == PortRole::strand)
        out_.ports[port].x = out_.fingers[all_.of(port).index] + side;
    }
  }

  // Places rows from `top` downward. Lines come in along a lane and turn below it. Returns the
  // bottom of the rows.
  double place_rows(std::vector<Arc>& arcs, double top) {
    for (std::size_t row = 0;; ++row) {
      std::vector<Arc*> here;
      bool straight = true;
      double radius = 0;
      for (Arc& arc : arcs) {
        if (arc.row != row) continue;
        here.push_back(&arc);
        arc.centre = (columns_[arc.gap].x + columns_[arc.gap + 1].x) / 2;
        arc.radius = in_one_block(arc.gap) ? tip_radius : turn_radius;
        radius = std::max(radius, arc.radius);
        straight = straight && columns_[arc.left].x == arc.centre - arc.radius &&
                   columns_[arc.right].x == arc.centre + arc.radius;
      }
      if (here.empty()) return top;
      const double lane = top + 8;
      const double centre = lane + (straight ? 12 : 2 * bend + 2);
      for (const Arc* arc : here) {
        out_.ports[arc->left_port] = {arc->centre - arc->radius, centre};
        out_.ports[arc->right_port] = {arc->centre + arc->radius, centre};
        lanes_[arc->left_port] = lanes_[arc->right_port] = lane;
      }
      top = centre + radius + sleeve + 4;
    }
  }

  void place_hand() {
    double y = 0;
    arch_ = y + 12;
    const auto is_stretch = [](const ColumnBlock& block) { return block.finger == 0; };
    if (std::ranges::any_of(blocks_, is_stretch)) y = arch_ + 20 + label_height;
    fixed_ = y + 12;
    const auto is_fixed = [](const Column& column) { return column.port == nowhere; };
    if (std::ranges::any_of(columns_, is_fixed)) y = fixed_ + fixation_depth + 4;
    y = place_rows(hand_arcs_, y);
    constexpr double least = 34;
    out_.hand = {-flesh, 0, out_.width + flesh, std::max(y + 10, least)};
    out_.bottom = out_.hand.bottom;
  }

  void place_motor_side() {
    const double sheath = out_.hand.bottom - 6 + sheath_length / 2;
    motor_labels_ = sheath + sheath_length / 2 + 8;
    out_.carriage_top = motor_labels_ + label_step + label_height + 8;
    tied_ = out_.carriage_top + 12;
    for (const Column& column : columns_) {
      if (!passes_sheath(column)) continue;
      out_.ports[column.port] = out_.ports[all_.ports[column.port].twin] = {column.x, sheath};
    }
    bool any = false;
    bool any_tied = false;
    for (std::size_t i = 0; i < net_.segments.size(); ++i) {
      if (kind(i) != SegmentKind::motor_side) continue;
      const auto [begin, end] = all_.segments[i].port;
      any = true;
      any_tied = any_tied || begin == nowhere || end == nowhere;
    }
    if (!any) return;
    const double y = any_tied ? tied_ + knot_size / 2 + 2 : out_.carriage_top + 4;
    out_.bottom = place_rows(carriage_arcs_, y) + 8;
  }

  void add_pieces(std::size_t i) {
    const auto& port = all_.segments[i].port;
    const auto [front, back] = columns_of_[i];
    const Column& column = columns_[front != nowhere ? front : back];
    const auto add_lane = [&](std::size_t side) {
      if (port[side] == nowhere || all_.ports[port[side]].role != PortRole::turn) return;
      double from = out_.ports[port[side]].x;
      double to = columns_[column_at_[port[side]]].x;
      if (side == 1) std::swap(from, to);
      out_.pieces[i].push_back({lanes_[port[side]], from, to});
    };
    add_lane(0);
    const bool arched = front != nowhere && back != nowhere && front != back;
    // A stretch between two contacts bends over at its top.
    if (arched) out_.pieces[i].push_back({arch_, columns_[front].x, columns_[back].x, pitch / 2});
    add_lane(1);
    switch (kind(i)) {
      case SegmentKind::strand:
        out_.loose[i] = {column.x, fixed_};
        break;
      case SegmentKind::hand:
        place_stretch(i, column);
        if (arched) {
          const double middle = (columns_[front].x + columns_[back].x) / 2;
          out_.labels[i] = {{middle, arch_ + 18}, Align::middle};
        }
        break;
      case SegmentKind::motor_side: {
        const bool first = front == blocks_[column.block].first;
        out_.loose[i] = {column.x, tied_};
        out_.labels[i] = {{column.x, motor_labels_ + (first ? 0 : label_step)},
                          first ? Align::start : Align::end};
        break;
      }
    }
  }

  // An end of a stretch that is fixed is fixed at its top; of one that is fixed at both, the other
  // hangs down.
  void place_stretch(std::size_t i, const Column& column) {
    const Point top{column.x, arch_ + 4};
    out_.loose[i] = top;
    out_.labels[i] = {{column.x, arch_ + 18}, Align::start};
    for (const std::size_t port : all_.segments[i].port) {
      if (port == nowhere || all_.ports[port].role != PortRole::clamp) continue;
      out_.ports[port] = top;
      out_.loose[i] = {column.x, fixed_};
    }
  }

  const Network& net_;
  Places out_;
  const Fittings& all_;
  std::vector<ColumnBlock> blocks_;
  std::vector<Column> columns_;
  std::vector<std::size_t> column_at_;                  // [port]: column of its line
  std::vector<std::array<std::size_t, 2>> columns_of_;  // [segment]: columns of its begin and end
  std::vector<double> lanes_;                           // [port of a turn]: y
  std::vector<bool> widened_;  // [column]: true if the gap behind it must hold a turn
  std::vector<Arc> hand_arcs_;
  std::vector<Arc> carriage_arcs_;
  double arch_ = 0;   // top of the stretches at the hand
  double fixed_ = 0;  // height at which strands are fixed
  double motor_labels_ = 0;
  double tied_ = 0;
};

}  // namespace

Places places_in_rows(const Network& network, Fittings fittings) {
  return RowPlacement(network, std::move(fittings)).place();
}

}  // namespace reeve::drawing
