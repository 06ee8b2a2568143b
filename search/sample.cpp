#include "search/sample.hpp"

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
