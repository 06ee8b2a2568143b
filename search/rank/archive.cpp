#include "search/rank/archive.hpp"

#include <algorithm>
#include <numeric>
#include <utility>

namespace reeve::search {
namespace {

// Thinning out costs more than filling, so it waits until a good part is new.
constexpr std::size_t least_backlog = 512;

bool equal(const Goodness& a, const Goodness& b) { return (a == b).all(); }

bool greater(const Goodness& a, const Goodness& b) {
  return std::lexicographical_compare(b.begin(), b.end(), a.begin(), a.end());
}

}  // namespace

Archive::Archive(Order order, std::size_t keep) : order_(std::move(order)), keep_(keep) {}

bool Archive::may_rank(const ObjectiveValues& values) const {
  const Goodness candidate = goodness(values, order_.objectives);
  if (climbs_) return !staircase_.proves_dominators(candidate);
  if (corner_.size() > 0 && (candidate < corner_).all()) return false;
  return !has_enough_dominators(guards_.rows(), candidate, 0);
}

void Archive::add(Design design, std::uint64_t equals_left_out) {
  Goodness value = goodness(design.values, order_.objectives);
  entries_.push_back(
      std::make_unique<Entry>(Entry{std::move(design), std::move(value), equals_left_out}));
  if (entries_.size() - compacted_ > std::max(least_backlog, compacted_ / 4)) compact();
}

// `beaten` are known to beat it besides.
bool Archive::has_enough_dominators(Eigen::Index rows, const Goodness& candidate,
                                    Eigen::Index beaten) const {
  const auto enough = static_cast<Eigen::Index>(keep_);
  // Counting costs time for each row, and there are not even as many.
  if (rows + beaten < enough) return false;
  return count_dominators(guards_, rows, candidate, enough) + beaten >= enough;
}

// Sorts the entries added since the last call, then merges them with the others.
void Archive::sort_entries() {
  const auto precedes = [this](const Place& a, const Place& b) {
    if (!equal(a->goodness, b->goodness)) return greater(a->goodness, b->goodness);
    return precedes_within_front(a->design, b->design, order_);
  };
  const auto newer = entries_.begin() + static_cast<std::ptrdiff_t>(compacted_);
  std::sort(newer, entries_.end(), precedes);
  std::inplace_merge(entries_.begin(), newer, entries_.end(), precedes);
}

void Archive::compact() {
  if (compacted_ == entries_.size()) return;
  KGreatest seconds(keep_);
  sort_entries();
  const auto enough = static_cast<Eigen::Index>(keep_);
  // Resizes in two steps: if memory runs out, a direct resize would leave a matrix that is freed
  // twice.
  guards_.resize(0, 0);
  guards_.resize(static_cast<Eigen::Index>(entries_.size()),
                 static_cast<Eigen::Index>(order_.objectives.size()));
  Eigen::Index kept = 0;
  Eigen::Index equals = 0;  // kept entries that equal the next one
  for (Place& place : entries_) {
    const Entry& entry = *place;
    Entry* last = kept == 0 ? nullptr : &*entries_[static_cast<std::size_t>(kept - 1)];
    const bool is_twin = last != nullptr && equal(last->goodness, entry.goodness);
    equals = is_twin ? equals : 0;
    if (is_twin && equals >= enough) {
      last->equals_left_out += entry.equals_left_out + 1;
      continue;
    }
    if (sweeps() ? seconds.has_all_above(second_value(entry.goodness))
                 : has_enough_dominators(kept, entry.goodness, equals)) {
      continue;
    }
    if (sweeps()) seconds.add(second_value(entry.goodness));
    guards_.row(kept) = entry.goodness.transpose();
    Place& slot = entries_[static_cast<std::size_t>(kept)];
    if (&slot != &place) slot = std::move(place);
    ++kept;
    ++equals;
  }
  entries_.erase(entries_.begin() + kept, entries_.end());
  guards_.conservativeResize(kept, Eigen::NoChange);
  compacted_ = entries_.size();
  place_guards();
}

void Archive::place_guards() {
  climbs_ = Staircase::can_hold(guards_);
  if (climbs_) {
    staircase_ = Staircase(guards_, keep_);
  } else {
    place_corner();
  }
}

// Guards that are good in their weakest objective span a deep corner.
void Archive::place_corner() {
  const auto keep = static_cast<Eigen::Index>(keep_);
  if (guards_.rows() < keep) return;
  const Goodness low = guards_.colwise().minCoeff().transpose();
  const Goodness span = (guards_.colwise().maxCoeff().transpose() - low).max(1e-300);
  std::vector<double> weakest;
  for (Eigen::Index i = 0; i < guards_.rows(); ++i) {
    weakest.push_back(((guards_.row(i).transpose() - low) / span).minCoeff());
  }
  std::vector<Eigen::Index> order(weakest.size());
  std::iota(order.begin(), order.end(), Eigen::Index{0});
  const auto last = order.begin() + static_cast<std::ptrdiff_t>(keep_) - 1;
  std::nth_element(order.begin(), last, order.end(), [&](Eigen::Index a, Eigen::Index b) {
    return weakest[static_cast<std::size_t>(a)] > weakest[static_cast<std::size_t>(b)];
  });
  corner_ = guards_.row(order.front()).transpose();
  for (auto guard = order.begin(); guard != last + 1; ++guard) {
    corner_ = corner_.min(guards_.row(*guard).transpose());
  }
}

std::vector<ArchivedDesign> Archive::members() {
  compact();
  std::vector<ArchivedDesign> members;
  members.reserve(entries_.size());
  for (const Place& entry : entries_) members.push_back({entry->design, entry->equals_left_out});
  return members;
}

Archive::Content Archive::ranked_content(std::vector<Design> designs) const {
  Content content;
  content.ranked = rank(std::move(designs), order_);
  for (const RankedDesign& ranked : content.ranked) {
    if (ranked.front == 1) content.front_equals_left_out += entries_[ranked.given]->equals_left_out;
  }
  return content;
}

Archive::Content Archive::content() & {
  compact();
  std::vector<Design> designs;
  designs.reserve(entries_.size());
  for (const Place& entry : entries_) designs.push_back(entry->design);
  return ranked_content(std::move(designs));
}

Archive::Content Archive::content() && {
  compact();
  std::vector<Design> designs;
  designs.reserve(entries_.size());
  for (const Place& entry : entries_) designs.push_back(std::move(entry->design));
  Content content = ranked_content(std::move(designs));
  *this = Archive(order_, keep_);
  return content;
}

}  // namespace reeve::search
