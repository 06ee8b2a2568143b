// The layout of a hand with floating blocks, bars or anchored tips.
//
// Fingers stand at the top, by number. Below, in the palm, blocks and joins lie in levels, each
// where its lines run straight, upright or inverted (facing.cpp), from left to right so that lines
// cross each other seldom and are short; then come the sheaths and the carriage. A line runs down
// from a port to a lane between two levels, along it and on (levels.hpp); whatever passes the same
// height keeps its distance (columns.hpp). So no line lies on another or under a symbol or a text,
// and lines cross at right angles only.
#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "drawing/schematic/columns.hpp"
#include "drawing/schematic/places.hpp"

namespace reeve::drawing {
namespace {

using measures::flesh;
using PortOrder = std::vector<std::size_t>;

// More than anything else in the cost of a hand of this size.
constexpr double cost_of_crossing = 10000;

struct Arrangement {
  Lanes lanes;
  Heights heights;
  Columns columns;
};

// A straight line, upright or level.
struct Straight {
  double at = 0;  // x if it is upright, y if it is level
  double from = 0;
  double to = 0;
};

Straight straight(double at, double a, double b) { return {at, std::min(a, b), std::max(a, b)}; }

struct Straights {
  std::vector<Straight> upright;
  std::vector<Straight> level;
};

Straights straights(const Fittings& all, const Arrangement& made) {
  Straights found;
  for (const LaneStretch& stretch : made.lanes.stretches) {
    const double y = height(made.heights, stretch);
    const double one = column(all, made.columns, stretch.port[0]);
    const double other = column(all, made.columns, stretch.port[1]);
    found.level.push_back(straight(y, one, other));
    for (const std::size_t end : {0U, 1U}) {
      const double x = end == 0 ? one : other;
      found.upright.push_back(straight(x, y, height(all, made.heights, stretch.port[end])));
    }
  }
  for (const Fitting& sheath : all.fittings) {
    if (sheath.carrier == nowhere) continue;
    found.upright.push_back(straight(column(all, made.columns, sheath.carrier),
                                     height(all, made.heights, sheath.carrier),
                                     made.heights.level[sheath.level]));
  }
  return found;
}

// Little: few crossings, first of all; then short level stretches, and a narrow drawing.
double cost(const Fittings& all, const Arrangement& made) {
  const Straights found = straights(all, made);
  double cost = made.columns.right / 4 + made.heights.bottom / 4;
  for (const Straight& level : found.level) {
    cost += level.to - level.from;
    for (const Straight& upright : found.upright) {
      const bool cross = upright.at > level.from + 1 && upright.at < level.to - 1 &&
                         level.at > upright.from + 1 && level.at < upright.to - 1;
      if (cross) cost += cost_of_crossing;
    }
  }
  return cost;
}

// Limit in pairs of ports evaluated: some seconds.
constexpr std::size_t most_work = 10'000'000;

class Arranging {
 public:
  Arranging(const Network& network, Fittings& all) : net_(network), all_(all) {}

  Arrangement run() {
    order_ = first_order();
    for (std::size_t i = 0; i < all_.fittings.size(); ++i) untwist(i);
    best_ = attempt();
    if (std::isinf(best_)) {
      put_outside();
      best_ = attempt();
    }
    for (bool improved = true; improved;) {
      improved = swap_neighbours();
      if (best_ > cost_of_crossing) improved = move_far() || improved;
      improved = rearrange_ports() || improved;
    }
    attempt();
    return std::move(made_);
  }

 private:
  // True if the fitting has a column of its own.
  bool is_free(std::size_t fitting) const {
    const Fitting& f = all_.fittings[fitting];
    return f.carrier == nowhere && f.inside == nowhere && f.kind != FittingKind::finger;
  }

  // Fittings between those that their lines lead to, fingers in their places.
  PortOrder first_order() const {
    const std::size_t size = all_.fittings.size();
    std::vector<double> place(size, 0);
    for (int f = 0; f < net_.fingers; ++f) place[static_cast<std::size_t>(f)] = f;
    constexpr int rounds = 20;
    for (int round = 0; round < rounds; ++round) {
      for (std::size_t i = 0; i < size; ++i) {
        if (all_.fittings[i].kind != FittingKind::finger) place[i] = mean_of_neighbours(i, place);
      }
    }
    PortOrder order;
    for (std::size_t i = 0; i < size; ++i) {
      if (is_free(i) || all_.fittings[i].kind == FittingKind::finger) order.push_back(i);
    }
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t a, std::size_t b) { return place[a] < place[b]; });
    return order;
  }

  double mean_of_neighbours(std::size_t fitting, const std::vector<double>& place) const {
    double sum = 0;
    double count = 0;
    for_each_neighbour(fitting, [&](std::size_t port, std::size_t other) {
      static_cast<void>(port);
      const std::size_t of = all_.ports[other].fitting;
      if (of == fitting) return;
      sum += place[of] + 1e-3 * all_.ports[other].offset;
      ++count;
    });
    return count == 0 ? place[fitting] : sum / count;
  }

  template <typename Visit>
  void for_each_neighbour(std::size_t fitting, Visit visit) const {
    for (const SegmentEnds& segment : all_.segments) {
      for (const std::size_t side : {0U, 1U}) {
        const std::size_t port = segment.port[side];
        const std::size_t other = segment.port[1 - side];
        if (port == nowhere || other == nowhere || all_.ports[port].fitting != fitting) continue;
        visit(port, other);
      }
    }
  }

  double place_in_order(std::size_t fitting) const {
    const auto at = std::find(order_.begin(), order_.end(), fitting);
    return static_cast<double>(at - order_.begin());
  }

  // Mirrored if its lines would cross otherwise: more of them lead from its left to the right.
  void untwist(std::size_t fitting) {
    if (!can_mirror(fitting)) return;
    double twist = 0;
    for_each_neighbour(fitting, [&](std::size_t port, std::size_t other) {
      const std::size_t of = column_of(all_, other).fitting;
      if (of == fitting) return;
      twist += all_.ports[port].offset * (place_in_order(fitting) - place_in_order(of));
    });
    if (twist > 0) reorder(fitting, reversed(all_.fittings[fitting].ports));
  }

  bool can_mirror(std::size_t fitting) const {
    const FittingKind kind = all_.fittings[fitting].kind;
    return kind == FittingKind::block || kind == FittingKind::join || kind == FittingKind::pulley;
  }

  void reorder(std::size_t fitting, const PortOrder& ports) {
    all_.fittings[fitting].ports = ports;
    place_ports(net_, fitting, all_);
  }

  static PortOrder reversed(PortOrder ports) {
    std::reverse(ports.begin(), ports.end());
    return ports;
  }

  Ranks ranks() const {
    constexpr double of_offset = 1e-3;  // strands of a finger lie 29 px off its middle
    Ranks ranks(all_.ports.size(), 0);
    std::vector<double> place(all_.fittings.size(), 0);
    for (std::size_t i = 0; i < order_.size(); ++i) place[order_[i]] = static_cast<double>(i);
    for (std::size_t p = 0; p < ranks.size(); ++p) {
      const ColumnOf at = column_of(all_, p);
      const Fitting& fitting = all_.fittings[at.fitting];
      if (fitting.inside != nowhere) {
        ranks[p] = place[fitting.inside] + at.offset * of_offset / 100;
      } else {
        const bool finger = fitting.kind == FittingKind::finger;
        ranks[p] = place[at.fitting] + at.offset * (finger ? of_offset : of_offset / 10);
      }
    }
    return ranks;
  }

  // Lays everything out; infinite if it does not go.
  double attempt() {
    const Ranks rank = ranks();
    made_.lanes = lanes(all_, rank);
    made_.heights = heights(net_, all_, made_.lanes);
    const std::optional<Columns> found = columns(net_, all_, made_.lanes, made_.heights, rank);
    if (!found) return std::numeric_limits<double>::infinity();
    made_.columns = *found;
    return cost(all_, made_);
  }

  // Moves all fittings out from between the strands of a finger.
  void put_outside() {
    for (std::size_t i = 0; i < all_.fittings.size(); ++i) {
      Fitting& fitting = all_.fittings[i];
      if (fitting.inside == nowhere) continue;
      const auto finger = std::find(order_.begin(), order_.end(), fitting.inside);
      fitting.inside = nowhere;
      if (fitting.carrier == nowhere) order_.insert(finger + 1, i);
    }
  }

  // No drawing takes long: one of very many parts is taken as it is after some tries.
  bool keep_if_better() {
    if (work_ > most_work) return false;
    work_ += all_.ports.size() * all_.ports.size();
    const double now = attempt();
    if (!(now < best_ - 1e-6)) return false;
    best_ = now;
    return true;
  }

  bool both_fingers(std::size_t a, std::size_t b) const {
    return all_.fittings[a].kind == FittingKind::finger &&
           all_.fittings[b].kind == FittingKind::finger;
  }

  bool swap_neighbours() {
    bool improved = false;
    for (std::size_t i = 1; i < order_.size(); ++i) {
      if (both_fingers(order_[i - 1], order_[i])) continue;
      const PortOrder before = order_;
      std::swap(order_[i - 1], order_[i]);
      if (keep_if_better()) {
        improved = true;
      } else {
        order_ = before;
      }
    }
    return improved;
  }

  // One fitting to another place.
  bool move_far() {
    bool improved = false;
    for (std::size_t i = 0; i < all_.fittings.size(); ++i) {
      if (!is_free(i)) continue;
      for (std::size_t to = 0; to < order_.size(); ++to) {
        const PortOrder before = order_;
        order_.erase(std::find(order_.begin(), order_.end(), i));
        order_.insert(order_.begin() + static_cast<std::ptrdiff_t>(to), i);
        if (order_ == before) continue;
        if (keep_if_better()) {
          improved = true;
        } else {
          order_ = before;
        }
      }
    }
    return improved;
  }

  // A fitting mirrored as a whole, one pass of it alone, or two neighbours on it exchanged.
  bool rearrange_ports() {
    bool improved = false;
    for (std::size_t i = 0; i < all_.fittings.size(); ++i) {
      if (!can_mirror(i)) continue;
      const std::size_t count = all_.fittings[i].ports.size();
      improved = keep_ports_if_better(i, reversed(all_.fittings[i].ports)) || improved;
      for (std::size_t at = 0; at + 1 < count; ++at) {
        improved = keep_ports_if_better(i, exchanged(i, at)) || improved;
      }
    }
    return improved;
  }

  bool keep_ports_if_better(std::size_t fitting, const PortOrder& ports) {
    const PortOrder before = all_.fittings[fitting].ports;
    if (ports == before) return false;
    reorder(fitting, ports);
    if (keep_if_better()) return true;
    reorder(fitting, before);
    return false;
  }

  // Within a pass its two legs, otherwise what stands there and the next, both legs of a pass as
  // one.
  PortOrder exchanged(std::size_t fitting, std::size_t at) const {
    PortOrder ports = all_.fittings[fitting].ports;
    const auto legs = [&](std::size_t port) {
      const PortRole role = all_.ports[port].role;
      return role == PortRole::turn || role == PortRole::arm ? 2 : 1;
    };
    const auto begin = ports.begin() + static_cast<std::ptrdiff_t>(at);
    if (all_.ports[*begin].twin == *(begin + 1)) {
      std::iter_swap(begin, begin + 1);
      return ports;
    }
    const auto first = begin + 1 - legs(*begin);
    std::rotate(first, begin + 1, begin + 1 + legs(*(begin + 1)));
    return ports;
  }

  const Network& net_;
  Fittings& all_;
  PortOrder order_;
  Arrangement made_;
  double best_ = 0;
  std::size_t work_ = 0;
};

// The level pieces of each segment, in walk order.
void add_pieces(const Arrangement& made, Places& places) {
  for (const LaneStretch& stretch : made.lanes.stretches) {
    const auto [one, other] = places.fittings.segments[stretch.segment].port;
    // The upper of two stretches comes first.
    const bool backwards = stretch.port[1] == one || stretch.port[0] == other;
    const LevelPiece piece{height(made.heights, stretch),
                           places.ports[stretch.port[backwards ? 1 : 0]].x,
                           places.ports[stretch.port[backwards ? 0 : 1]].x};
    std::vector<LevelPiece>& pieces = places.pieces[stretch.segment];
    pieces.insert(backwards ? pieces.begin() : pieces.end(), piece);
  }
}

}  // namespace

Places places_in_levels(const Network& network, Fittings fittings) {
  face(fittings);
  const Arrangement made = Arranging(network, fittings).run();
  Places places(std::move(fittings));
  const Fittings& all = places.fittings;
  places.width = made.columns.right;
  for (int f = 0; f < network.fingers; ++f) {
    places.fingers.push_back(made.columns.middle[static_cast<std::size_t>(f)]);
  }
  for (std::size_t port = 0; port < all.ports.size(); ++port) {
    places.ports[port] = {column(all, made.columns, port), height(all, made.heights, port)};
  }
  add_pieces(made, places);
  for (std::size_t i = 0; i < all.segments.size(); ++i) {
    const auto [begin, end] = all.segments[i].port;
    if (begin == nowhere || end == nowhere) {
      const std::size_t port = begin == nowhere ? end : begin;
      const LooseEnd loose = all.segments[i].loose;
      places.loose[i] = {places.ports[port].x, loose_end(all, made.heights, port, loose)};
    }
    if (network.segments[i].kind == SegmentKind::strand) continue;
    const std::size_t port = labelled_port(network, all, i);
    places.labels[i].top = {places.ports[port].x, label_top(all, made.heights, port)};
  }
  places.hand = {-flesh / 2, 0, places.width + flesh / 2, made.heights.hand_bottom};
  places.carriage_top = made.heights.carriage_top;
  places.bottom = made.heights.bottom;
  return places;
}

}  // namespace reeve::drawing
