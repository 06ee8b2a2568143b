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
#include <map>
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

// Counts crossings of level stretches with upright lines: the order of both tells.
std::size_t crossings(const Arrangement& made, const std::vector<Strip>& strips,
                      const Ranks& ranks) {
  std::size_t count = 0;
  for (const LaneStretch& stretch : made.lanes.stretches) {
    const double y = height(made.heights, stretch);
    const auto [left, right] = std::minmax(ranks[stretch.port[0]], ranks[stretch.port[1]]);
    for (const Strip& strip : strips) {
      const bool passes = strip.segment != nowhere && strip.top < y && strip.bottom > y;
      if (passes && strip.rank > left && strip.rank < right) ++count;
    }
  }
  return count;
}

// Limit in pairs of ports evaluated: about half a second.
constexpr std::size_t most_work = 100'000'000;

class Arranging {
 public:
  Arranging(const Network& network, Fittings& all) : net_(network), all_(all) {}

  Arrangement run() {
    order_ = first_order();
    for (std::size_t i = 0; i < all_.fittings.size(); ++i) untwist(i);
    if (!keep_if_better()) {
      put_outside();
      keep_if_better();
    }
    improve(infinity);
    only_crossings_ = false;
    improve(1);
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
    std::ranges::stable_sort(order,
                             [&](std::size_t a, std::size_t b) { return place[a] < place[b]; });
    return order;
  }

  double mean_of_neighbours(std::size_t fitting, const std::vector<double>& place) const {
    double sum = 0;
    double count = 0;
    for_each_neighbour(fitting, [&](std::size_t, std::size_t other) {
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
    const auto at = std::ranges::find(order_, fitting);
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
    std::ranges::reverse(ports);
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

  // Moves all fittings out from between the strands of a finger.
  void put_outside() {
    for (std::size_t i = 0; i < all_.fittings.size(); ++i) {
      Fitting& fitting = all_.fittings[i];
      if (fitting.inside == nowhere) continue;
      const auto finger = std::ranges::find(order_, fitting.inside);
      fitting.inside = nowhere;
      if (fitting.carrier == nowhere) order_.insert(finger + 1, i);
    }
  }

  // Returns what an arrangement has to cost less than. At first only fewer crossings count.
  double limit() const {
    return only_crossings_ ? cost_of_crossing * std::floor(best_ / cost_of_crossing) : best_;
  }

  // Lays out only what may be better: how much an arrangement costs at least is known from the last
  // time that it was tried, or from its crossings. No drawing takes long: one of very many parts is
  // taken as it is after some tries.
  bool keep_if_better() {
    double& least = known_[orders()];
    if (least >= limit() || work_ > most_work) return false;
    work_ += all_.ports.size() * all_.ports.size();
    Arrangement made;
    const Ranks rank = ranks();
    made.lanes = lanes(all_, rank);
    made.heights = heights(net_, all_, made.lanes);
    std::vector<Strip> cut = strips(net_, all_, made.lanes, made.heights, rank);
    const std::size_t count = crossings(made, cut, rank);
    least = cost_of_crossing * static_cast<double>(count) + made.heights.bottom / 4;
    if (least >= limit()) return false;
    std::optional<Columns> found = columns(all_, made.lanes, std::move(cut), best_ - least);
    least = found ? least + found->cost : infinity;
    if (!found) return false;
    best_ = least;
    made.columns = std::move(*found);
    made_ = std::move(made);
    return true;
  }

  // Returns all that is searched over.
  PortOrder orders() const {
    PortOrder orders = order_;
    for (const Fitting& fitting : all_.fittings) {
      orders.insert(orders.end(), fitting.ports.begin(), fitting.ports.end());
    }
    return orders;
  }

  void improve(double reach) {
    for (bool improved = true; improved && limit() > 0;) {
      improved = rearrange_ports();
      improved = move(reach) || improved;
    }
  }

  // Moves one fitting to another place.
  bool move(double reach) {
    bool improved = false;
    for (std::size_t i = 0; i < all_.fittings.size(); ++i) {
      if (!is_free(i)) continue;
      for (std::size_t to = 0; to < order_.size(); ++to) {
        if (std::abs(place_in_order(i) - static_cast<double>(to)) > reach) continue;
        const PortOrder before = order_;
        std::erase(order_, i);
        order_.insert(order_.begin() + static_cast<std::ptrdiff_t>(to), i);
        if (keep_moved_if_better(i)) {
          improved = true;
        } else {
          order_ = before;
        }
      }
    }
    return improved;
  }

  // Tries it as it is, mirrored, or with a pass turned over that one of its lines leads to.
  bool keep_moved_if_better(std::size_t fitting) {
    bool kept =
        keep_if_better() || keep_ports_if_better(fitting, reversed(all_.fittings[fitting].ports));
    for_each_neighbour(fitting, [&](std::size_t, std::size_t other) {
      kept = kept || keep_ports_if_better(all_.ports[other].fitting, turned_over(other));
    });
    return kept;
  }

  // A fitting mirrored as a whole, one pass of it alone, or two neighbours on it exchanged.
  bool rearrange_ports() {
    bool improved = false;
    for (std::size_t i = 0; i < all_.fittings.size(); ++i) {
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
    if (!can_mirror(fitting) || ports == before) return false;
    reorder(fitting, ports);
    if (keep_if_better()) return true;
    reorder(fitting, before);
    return false;
  }

  // Exchanges the legs of a pass.
  PortOrder turned_over(std::size_t leg) const {
    PortOrder ports = all_.of(leg).ports;
    const std::size_t twin = all_.ports[leg].twin;
    if (twin == nowhere) return ports;
    std::iter_swap(std::ranges::find(ports, leg), std::ranges::find(ports, twin));
    return ports;
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
    if (all_.ports[*begin].twin == *(begin + 1)) return turned_over(*begin);
    const auto first = begin + 1 - legs(*begin);
    std::rotate(first, begin + 1, begin + 1 + legs(*(begin + 1)));
    return ports;
  }

  const Network& net_;
  Fittings& all_;
  PortOrder order_;
  Arrangement made_;
  double best_ = infinity;
  bool only_crossings_ = true;
  std::map<PortOrder, double> known_;  // least cost
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
