// The ways to give distinct fingers, or several motors, to the tendons of a routing.
#pragma once

#include <cstdint>
#include <string>
#include <unordered_set>
#include <vector>

#include "core/canonical.hpp"
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

// Numberings of the carriages that a routing's ends and pulleys are on, each motor used at least
// once, up to what makes no difference: the symmetries of the routing and, with identical fingers,
// the names of the motors. They follow by the numbers along the word of the routing of one motor,
// so that all routings of several motors that have the same such routing follow each other.
class CarriageNumbering {
 public:
  CarriageNumbering(int motors, FingerIdentity identity) : motors_(motors), identity_(identity) {}

  // Starts with a canonical routing of one motor.
  void start(const Routing& of_one_motor);
  // False when all have been given; each is canonical.
  bool next(Routing& routing);

 private:
  bool advance();
  bool uses_all() const;

  int motors_;
  FingerIdentity identity_;
  Routing routing_;
  std::vector<std::uint8_t*> numbers_;  // motor numbers of the tokens on a carriage
  bool at_first_ = false;
  std::unordered_set<std::string> given_;  // numberings given for the current routing of one motor
};

}  // namespace reeve::search
