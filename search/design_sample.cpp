#include "search/design_sample.hpp"

#include <algorithm>
#include <utility>

#include "numerics/random.hpp"
#include "numerics/streams.hpp"

namespace reeve::search {
namespace {

constexpr std::uint64_t sample_seed = 0;

double lot(std::uint64_t place) { return uniform(sample_seed, streams::design_sample, place); }

}  // namespace

bool DesignSample::would_enter(std::uint64_t place) const {
  if (members_.size() < size_) return true;
  return size_ > 0 && lot(place) < members_.front().lot;
}

bool DesignSample::may_have_one(const ShardRange& places) const {
  if (knows(places)) {
    const auto first = std::lower_bound(low_.places.begin(), low_.places.end(), places.begin);
    const auto last = std::lower_bound(first, low_.places.end(), places.end);
    return std::any_of(first, last, [this](std::uint64_t place) { return would_enter(place); });
  }
  // Some hundredths of a second to look at.
  constexpr std::uint64_t many = 1 << 22;
  if (places.end - places.begin > many) return true;
  for (std::uint64_t place = places.begin; place < places.end; ++place) {
    if (would_enter(place)) return true;
  }
  return false;
}

// True if those with low lots are all that would enter.
bool DesignSample::knows(const ShardRange& places) const {
  if (size_ == 0) return true;
  return low_.of.begin <= places.begin && places.end <= low_.of.end && members_.size() == size_ &&
         members_.front().lot <= low_.bound;
}

// The bound is passed after a small part of the places; up to there they are looked at one by one.
void DesignSample::foresee(const ShardRange& places, Workers& workers,
                           const std::atomic<bool>* stop) {
  constexpr double many_times = 256;
  constexpr std::uint64_t at_a_time = 1 << 20;
  const auto count = static_cast<double>(places.end - places.begin);
  const double bound = std::min(1.0, many_times * static_cast<double>(size_) / count);
  const auto blocks = static_cast<std::size_t>((places.end - places.begin) / at_a_time) + 1;
  std::vector<std::vector<std::uint64_t>> low(blocks);
  const auto is_stopped = [&] { return stop != nullptr && stop->load(); };
  workers.for_each_block(blocks, 1, [&](const IndexBlock& block) {
    const std::uint64_t begin = places.begin + block.begin * at_a_time;
    const std::uint64_t end = std::min(begin + at_a_time, places.end);
    if (!is_stopped()) {
      low[block.begin] = uniform_below(bound, sample_seed, streams::design_sample, begin, end);
    }
  });
  if (is_stopped()) return;
  low_ = {places, bound, {}};
  for (const auto& part : low) low_.places.insert(low_.places.end(), part.begin(), part.end());
}

void DesignSample::add(std::uint64_t place, const Routing& routing) {
  if (!would_enter(place)) return;
  if (members_.size() == size_) {
    std::pop_heap(members_.begin(), members_.end());
    members_.pop_back();
  }
  members_.push_back({lot(place), place, routing});
  std::push_heap(members_.begin(), members_.end());
}

std::vector<SampledRouting> DesignSample::members() const {
  std::vector<SampledRouting> members;
  for (const Member& member : members_) members.push_back({member.place, member.routing});
  std::sort(members.begin(), members.end(),
            [](const SampledRouting& a, const SampledRouting& b) { return a.place < b.place; });
  return members;
}

std::vector<Routing> DesignSample::routings() const {
  std::vector<Routing> routings;
  for (SampledRouting& member : members()) routings.push_back(std::move(member.routing));
  return routings;
}

}  // namespace reeve::search
