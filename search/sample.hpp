// A random sample out of a stream of any length: those few whose random numbers are the least.
//
// Each routing's number is a function of its place in the whole enumeration, so the sample is the
// same for any number of threads, and those of all shards together hold the sample of the whole.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/routing.hpp"

namespace reeve::search {

struct SampledRouting {
  std::uint64_t place = 0;
  Routing routing;
};

class DesignSample {
 public:
  explicit DesignSample(std::size_t size) : size_(size) {}

  // Whether the routing at this place of the enumeration would enter now; may be asked from many
  // threads.
  bool would_enter(std::uint64_t place) const;

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

  std::size_t size_;
  std::vector<Member> members_;  // a heap: the greatest lot first
};

}  // namespace reeve::search
