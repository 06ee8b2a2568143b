// A random sample out of a stream of any length: those few whose random numbers are the least.
//
// Each routing's number is a function of its place in the whole enumeration, so the sample is the
// same for any number of threads, and those of all shards together hold the sample of the whole.
#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/routing.hpp"
#include "numerics/parallel.hpp"
#include "search/enumerate/generator_options.hpp"

namespace reeve::search {

struct SampledRouting {
  std::uint64_t place = 0;
  Routing routing;
};

class DesignSample {
 public:
  explicit DesignSample(std::size_t size) : size_(size) {}

  // True if the routing at this place of the enumeration would enter now. Thread-safe.
  bool would_enter(std::uint64_t place) const;
  // True if one at these places might.
  bool may_have_one(const ShardRange& places) const;
  // Looks at all of these places beforehand, for may_have_one() of many of them. Without effect if
  // stopped.
  void foresee(const ShardRange& places, Workers& workers, const std::atomic<bool>* stop);

  void add(std::uint64_t place, const Routing& routing);

  // Both in the order of their places.
  std::vector<SampledRouting> members() const;
  std::vector<Routing> routings() const;

 private:
  struct Member {
    double lot = 0;
    std::uint64_t place = 0;
    Routing routing;

    bool operator<(const Member& other) const { return lot < other.lot; }
  };

  // The places among some whose lots are below a bound, in their order.
  struct LowLots {
    ShardRange of;
    double bound = 0;
    std::vector<std::uint64_t> places;
  };

  bool knows(const ShardRange& places) const;

  std::size_t size_;
  std::vector<Member> members_;  // a heap: the greatest lot first
  LowLots low_;
};

}  // namespace reeve::search
