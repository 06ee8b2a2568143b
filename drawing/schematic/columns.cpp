#include "drawing/schematic/columns.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace reeve::drawing {
namespace {

constexpr double far = 1e9;
constexpr double no_distance = -2 * far;
constexpr double rounding = 1e-6;

bool keep_apart(const Strip& a, const Strip& b) {
  if (a.fitting == b.fitting || a.rank == b.rank) return false;
  if (std::min(a.bottom, b.bottom) - std::max(a.top, b.top) < 0.01) return false;
  // Both ends of a line that runs on: they may lie over each other.
  return a.segment == nowhere || a.segment != b.segment || a.rises == b.rises;
}

struct Distance {
  std::size_t left = 0;
  std::size_t right = 0;
  double least = 0;
};

std::vector<Distance> distances(std::size_t size, const std::vector<Strip>& strips) {
  std::vector<double> least(size * size, no_distance);
  for (const Strip& a : strips) {
    for (const Strip& b : strips) {
      if (!(a.rank < b.rank) || !keep_apart(a, b)) continue;
      double& at = least[a.fitting * size + b.fitting];
      at = std::max(at, std::ceil(a.right - b.left));
    }
  }
  std::vector<Distance> found;
  for (std::size_t i = 0; i < size; ++i) {
    for (std::size_t j = 0; j < size; ++j) {
      if (least[i * size + j] > no_distance) found.push_back({i, j, least[i * size + j]});
    }
  }
  return found;
}

// Wished place of a fitting.
struct Wish {
  std::size_t other = 0;
  double ahead = 0;      // distance from the other's middle
  bool straight = true;  // otherwise the line turns back anyhow
};

class Spacing {
 public:
  Spacing(const Fittings& all, const Lanes& lanes, const std::vector<Strip>& strips)
      : all_(all),
        x_(all.fittings.size(), 0),
        distances_(distances(x_.size(), strips)),
        wishes_(x_.size()) {
    for (const LaneStretch& stretch : lanes.stretches) add_wishes(stretch);
    for (std::vector<Wish>& wishes : wishes_) keep_straight_ones(wishes);
  }

  bool solve() {
    if (!push()) return false;
    constexpr int rounds = 30;
    for (int round = 0; round < rounds; ++round) {
      for (std::size_t i = 0; i < x_.size(); ++i) x_[i] = wished(i);
      for (int sweep = 0; sweep < rounds; ++sweep) {
        if (!share()) break;
      }
    }
    if (!push()) return false;
    for (int round = 0; round < rounds; ++round) {
      if (!settle()) break;
    }
    for (double& x : x_) x = std::floor(x + 0.5);
    straighten();
    return true;
  }

  const std::vector<double>& middles() const { return x_; }

 private:
  void add_wishes(const LaneStretch& stretch) {
    const ColumnOf one = column_of(all_, stretch.port[0]);
    const ColumnOf other = column_of(all_, stretch.port[1]);
    const bool straight = stretch.rises[0] != stretch.rises[1];
    const auto add = [&](const ColumnOf& of, const ColumnOf& to) {
      const bool up_from_carriage = all_.fittings[to.fitting].kind == FittingKind::pulley;
      if (of.fitting == to.fitting || up_from_carriage) return;
      wishes_[of.fitting].push_back({to.fitting, to.offset - of.offset, straight});
    };
    add(one, other);
    add(other, one);
  }

  // Lines that turn back anyhow only count if there are no others.
  static void keep_straight_ones(std::vector<Wish>& wishes) {
    const auto straight = [](const Wish& wish) { return wish.straight; };
    if (std::none_of(wishes.begin(), wishes.end(), straight)) return;
    std::erase_if(wishes, [&](const Wish& wish) { return !straight(wish); });
  }

  // The median; between the two middle ones, if their number is even.
  double wished(std::size_t fitting) {
    if (wishes_[fitting].empty()) return x_[fitting];
    places_.clear();
    for (const Wish& wish : wishes_[fitting]) places_.push_back(x_[wish.other] + wish.ahead);
    std::sort(places_.begin(), places_.end());
    const std::size_t half = places_.size() / 2;
    return places_.size() % 2 == 1 ? places_[half] : (places_[half - 1] + places_[half]) / 2;
  }

  // Rightward until all distances are kept; false if that has no end.
  bool push() {
    for (std::size_t round = 0; round <= x_.size(); ++round) {
      bool moved = false;
      for (const Distance& distance : distances_) {
        const double least = x_[distance.left] + distance.least;
        if (x_[distance.right] >= least - rounding) continue;
        x_[distance.right] = least;
        moved = true;
      }
      if (!moved) return true;
    }
    return false;
  }

  // Each of two that are too close gives way by half; false if none are.
  bool share() {
    bool moved = false;
    for (const Distance& distance : distances_) {
      const double lacking = x_[distance.left] + distance.least - x_[distance.right];
      if (lacking <= rounding) continue;
      x_[distance.left] -= lacking / 2;
      x_[distance.right] += lacking / 2;
      moved = true;
    }
    return moved;
  }

  struct Room {
    double low = -far;
    double high = far;
  };

  Room room(std::size_t fitting) const {
    Room room;
    for (const Distance& distance : distances_) {
      if (distance.right == fitting) {
        room.low = std::max(room.low, x_[distance.left] + distance.least);
      }
      if (distance.left == fitting) {
        room.high = std::min(room.high, x_[distance.right] - distance.least);
      }
    }
    return room;
  }

  // Moves each fitting as far towards its wish as the others leave room. A finger without wishes
  // goes next to the others. False if nothing moves.
  bool settle() {
    bool moved = false;
    for (std::size_t i = 0; i < x_.size(); ++i) {
      const auto [low, high] = room(i);
      if (low > high) continue;
      double wish = wished(i);
      if (wishes_[i].empty() && all_.fittings[i].kind == FittingKind::finger) {
        wish = low > -far ? low : high < far ? high : wish;
      }
      const double to = std::clamp(wish, low, high);
      moved = moved || std::abs(to - x_[i]) > rounding;
      x_[i] = to;
    }
    return moved;
  }

  // Removes small steps in lines that run on: moves everything right of a step by its length, if
  // fewer steps remain.
  void straighten() {
    constexpr double small = 16;
    for (std::size_t i = 0; i < x_.size(); ++i) {
      for (const Wish& wish : wishes_[i]) {
        const double step = x_[wish.other] + wish.ahead - x_[i];
        if (wish.straight && step != 0 && std::abs(step) <= small) move_rest(i, step);
      }
    }
  }

  void move_rest(std::size_t first, double step) {
    const std::vector<double> before = x_;
    const double cost = steps();
    for (std::size_t i = 0; i < x_.size(); ++i) {
      if (before[i] >= before[first]) x_[i] += step;
    }
    const bool kept =
        std::all_of(distances_.begin(), distances_.end(), [&](const Distance& distance) {
          return x_[distance.right] >= x_[distance.left] + distance.least - rounding;
        });
    if (!kept || steps() >= cost) x_ = before;
  }

  // Their lengths, and something for each.
  double steps() const {
    constexpr double of_each = 24;
    double sum = 0;
    for (std::size_t i = 0; i < x_.size(); ++i) {
      for (const Wish& wish : wishes_[i]) {
        const double step = std::abs(x_[wish.other] + wish.ahead - x_[i]);
        if (wish.straight && step > rounding) sum += step + of_each;
      }
    }
    return sum;
  }

  const Fittings& all_;
  std::vector<double> x_;
  std::vector<Distance> distances_;
  std::vector<std::vector<Wish>> wishes_;
  std::vector<double> places_;
};

}  // namespace

std::optional<Columns> columns(const Network& network, const Fittings& all, const Lanes& lanes,
                               const Heights& heights, const Ranks& ranks) {
  const std::vector<Strip> cut = strips(network, all, lanes, heights, ranks);
  Spacing spacing(all, lanes, cut);
  if (!spacing.solve()) return std::nullopt;
  Columns found{spacing.middles()};
  double left = far;
  double right = -far;
  for (const Strip& strip : cut) {
    left = std::min(left, found.middle[strip.fitting] + strip.left);
    right = std::max(right, found.middle[strip.fitting] + strip.right);
  }
  for (double& x : found.middle) x -= left;
  found.right = right - left;
  return found;
}

double column(const Fittings& all, const Columns& columns, std::size_t port) {
  const auto [fitting, offset] = column_of(all, port);
  return columns.middle[fitting] + offset;
}

}  // namespace reeve::drawing
