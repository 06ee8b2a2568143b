// The routings without floating blocks of a set of parts within limits, one after the other, each
// once, in canonical order and at their places among all.
//
// Without finger numbers they are those of limits/limited_tendons.hpp. With distinct fingers, all
// numberings of one sequence of shapes follow each other before the next sequence: a numbering is
// one only if no symmetry of the tendons gives an earlier one (numbering.hpp). Nothing seen is
// remembered.
//
// `seek` starts at any index by skipping whole subtrees, whose sizes are counted, so that shards
// partition the whole without talking to each other; within one size of tendon, and for distinct
// fingers, it steps from shape to shape.
#pragma once

#include <cstdint>
#include <vector>

#include "core/routing.hpp"
#include "search/enumerate/generator_options.hpp"
#include "search/enumerate/numbering.hpp"
#include "search/limits/limited_tendons.hpp"

namespace reeve::search {

class TendonGenerator {
 public:
  // Tendons have up to so many fingers; if one is wanted, exactly as many. It refers to the
  // classes, which set no limits to distinct fingers. Throws InputError on impossible parts or
  // numbers of fingers.
  TendonGenerator(const GeneratorOptions& options, const PartClasses& classes);

  std::uint64_t total(int fingers) const { return totals_[static_cast<std::size_t>(fingers)]; }

  // The next call of next() gives the first routing from this index on that is within the limits
  // together with what is beside it.
  void seek(int fingers, PartClass beside, std::uint64_t index);

  // False when all have been given. Keeps the memory of `routing`.
  bool next(Routing& routing, std::uint64_t& index);

  // The routings of identical fingers.
  LimitedTendons& shapes() { return shapes_; }

 private:
  bool next_numbered();
  void seek_numbered(std::uint64_t index);

  bool is_distinct_;
  std::vector<std::uint64_t> totals_;  // [fingers]
  LimitedTendons shapes_;

  // The last routing given of distinct fingers, or the next one.
  Routing numbered_;
  Numbering numbering_;
  std::uint64_t next_index_ = 0;
  bool is_numbered_ = false;  // false if the next one has other shapes
  bool is_unread_ = false;
};

}  // namespace reeve::search
