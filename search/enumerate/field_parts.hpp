// The parts that hands of the field are built of, as many as an exploration of seconds can hold.
//
// These are full_parts(), tendons that are tied at a fingertip, and trees of floating blocks: one
// tendon pulls n fingers by n - 1 blocks. The number of routings grows by about five with each
// block, so parts are added one after the other while the number stays below a limit: first the
// tied fingertips, then block after block. Numbers come from formulas, not from a clock, so that
// the same request has the same answer on every machine.
#pragma once

#include <cstdint>
#include <optional>

#include "search/enumerate/generator.hpp"

namespace reeve::search {

// 1.4 million routings of four identical fingers and three blocks take 7 s of one core of a server
// of 2023, all that is written included: about 4 s on two cores and 1 s on eight. The next greater
// request, five fingers and two blocks, has 5.3 million.
inline constexpr std::uint64_t most_of_identical_fingers = 2'000'000;
// The limit is lower for fingers that are told apart: no tree is evaluated for more than one
// routing, which takes ten times as long. 137 thousand routings of three fingers and two blocks
// take 4 s of one core. 1.9 million of four fingers and a block take 26 s. Likewise for several
// motors, whose routings are numbered one by one.
inline constexpr std::uint64_t most_of_distinct_fingers = 200'000;

inline std::uint64_t most_field_routings(const GeneratorOptions& generator) {
  const bool alike = generator.identity == FingerIdentity::identical && generator.parts.motors == 1;
  return alike ? most_of_identical_fingers : most_of_distinct_fingers;
}

struct LeftOutParts {
  bool anchored = false;       // no tendon is tied at a fingertip
  int from_blocks = 0;         // the least number of blocks that is left out …
  int to_blocks = 0;           // … and the greatest that the fingers can use
  std::uint64_t routings = 0;  // number of routings with the next part, at least …
  std::uint64_t limit = 0;     // … and the number up to which all are explored by default
};

struct FieldParts {
  PartSet parts;
  std::optional<LeftOutParts> left_out;
};

// The number of blocks is chosen unless it is given.
struct FieldRequest {
  GeneratorOptions generator;  // its parts are allowed, however many routings they make
  std::optional<int> blocks;
};

// Throws InputError on impossible parts or where even the parts of the request are too many to
// count.
FieldParts field_parts(const FieldRequest& request);

}  // namespace reeve::search
