// The ways to give distinct fingers to the tendons of a routing.
#pragma once

#include <cstdint>
#include <vector>

#include "core/routing.hpp"

namespace reeve::search {

// Identical fingers: 1, 2, … in the order of the word.
void number_in_order(Routing& routing);

// Numberings of a sequence of tendons' fingers, up to the tendons' symmetries.
class Numbering {
 public:
  // Writes the first one into `routing`, whose tendons are in canonical order of shapes.
  void start(Routing& routing);
  bool next(Routing& routing);

 private:
  struct Place {
    std::size_t tendon;
    std::size_t token;
    bool opens_twin;   // first finger of a tendon of the same shape as the one before
    bool ends_tendon;  // last finger of its tendon
  };

  bool advance(Routing& routing, std::size_t place, int from);
  bool admits(const Routing& routing, const Place& place) const;

  std::vector<Place> places_;
  std::uint64_t used_ = 0;
};

}  // namespace reeve::search
