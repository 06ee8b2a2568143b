// Every routing without floating blocks that a set of parts allows, one after the other, each once,
// in canonical order.
//
// The tendons without finger numbers are those of limits/limited_tendons.hpp, of which none is
// beyond limits. With distinct fingers, all numberings of one sequence of shapes follow each other
// before the next sequence: a numbering is one only if no symmetry of the tendons gives an earlier
// one (numbering.hpp). Nothing seen is remembered.
//
// `seek` starts at any index by skipping whole subtrees, whose sizes are counted, so that shards
// partition the whole without talking to each other; within one size of tendon, and for distinct
// fingers, it steps from shape to shape.
#pragma once

#include <cstdint>

#include "core/routing.hpp"
#include "search/enumerate/generator_options.hpp"
#include "search/enumerate/numbering.hpp"
#include "search/limits/limited_tendons.hpp"
#include "search/stop_check.hpp"

namespace reeve::search {

class TendonGenerator {
 public:
  // Throws InputError on impossible parts or numbers of fingers.
  explicit TendonGenerator(const GeneratorOptions& options);
  // Its parts point at each other.
  TendonGenerator(const TendonGenerator&) = delete;
  TendonGenerator& operator=(const TendonGenerator&) = delete;

  std::uint64_t total() const { return total_; }

  // The next call of next() gives the routing of this index, from 0.
  void seek(std::uint64_t index);

  // False when all have been given. Keeps the memory of `routing`.
  bool next(Routing& routing);

  // The check is read on each step from shape to shape.
  void stop_with(const StopCheck& check) { shapes_.stop_with(check); }

 private:
  bool next_numbered();
  void seek_numbered(std::uint64_t index);

  GeneratorOptions options_;
  PartClasses all_alike_;
  LimitedTendons shapes_;
  std::uint64_t total_ = 0;

  // Of distinct fingers: the last routing given, or the next one.
  Routing numbered_;
  Numbering numbering_;
  bool is_numbered_ = false;  // false if the next one has other shapes
  bool is_unread_ = false;
};

}  // namespace reeve::search
