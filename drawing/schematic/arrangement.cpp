#include "drawing/schematic/arrangement.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "drawing/schematic/crossings.hpp"
#include "drawing/schematic/strips.hpp"

namespace reeve::drawing {
namespace {

using PortOrder = std::vector<std::size_t>;

// In pairs of ports looked at: some seconds at most.
constexpr std::size_t most_work = 10'000'000;

class Arranging {
 public:
  Arranging(const Network& network, double palm, Fittings& all)
      : net_(network), palm_(palm), all_(all) {}

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
  // What has a column of its own.
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
    made_.heights = heights(net_, all_, made_.lanes, palm_);
    const std::optional<Columns> found = columns(net_, all_, made_.lanes, made_.heights, rank);
    if (!found) return std::numeric_limits<double>::infinity();
    made_.columns = *found;
    return cost(all_, made_.lanes, made_.heights, made_.columns);
  }

  // Nothing between the strands of a finger.
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
  double palm_;
  Fittings& all_;
  PortOrder order_;
  Arrangement made_;
  double best_ = 0;
  std::size_t work_ = 0;
};

}  // namespace

Arrangement arrange(const Network& network, double palm, Fittings& all) {
  return Arranging(network, palm, all).run();
}

}  // namespace reeve::drawing
