// Every routing without floating blocks that a set of parts allows, one after the other, each once,
// in canonical order.
//
// A routing is a sequence of tendons in canonical order (canonical.hpp), so the generator is an
// odometer of tendons: the last one moves to its next shape, and when it has no more, it goes and
// the one before moves. A shape is one only if no other way to walk it comes earlier, and for
// distinct fingers a numbering of them only if no symmetry of the tendons gives an earlier one.
// Nothing seen is remembered. With distinct fingers, all numberings of one sequence of shapes
// follow each other before the next sequence. `seek` starts at any index by skipping whole
// subtrees, whose sizes are counted (counting.hpp), so that shards partition the whole without
// talking to each other; within one size of tendon, and for distinct fingers, it steps from shape
// to shape.
#pragma once

#include <cstdint>
#include <vector>

#include "core/canonical.hpp"
#include "core/routing.hpp"
#include "search/enumerate/counting.hpp"
#include "search/enumerate/numbering.hpp"
#include "search/enumerate/parts.hpp"
#include "search/enumerate/shape_cursor.hpp"
#include "search/stop_check.hpp"

namespace reeve::search {

struct GeneratorOptions {
  PartSet parts = full_parts();
  int fingers = 2;
  FingerIdentity identity = FingerIdentity::identical;
  bool one_tendon = false;  // only routings with a single tendon, or tree of tendons
};

class TendonGenerator {
 public:
  // Throws InputError on impossible parts or numbers of fingers.
  explicit TendonGenerator(GeneratorOptions options);

  std::uint64_t total() const { return total_; }

  // The next call of next() gives the routing of this index, from 0.
  void seek(std::uint64_t index);

  // False when all have been given. Keeps the memory of `routing`.
  bool next(Routing& routing);

  // The check is read in seek().
  void stop_with(const StopCheck& check) { check_ = check; }

 private:
  bool start_shapes();
  bool advance_shapes();
  void fill();
  void push(int largest);
  bool continues_last(int size) const;
  std::uint64_t completions(const ShapeCursor& last) const;
  void seek_by_subtrees(std::uint64_t index);
  bool seek_size(int size, std::uint64_t& index);
  void seek_step_by_step(std::uint64_t index);
  std::uint64_t numberings() const;
  void write(Routing& routing) const;

  GeneratorOptions options_;
  TendonCounts shapes_;
  std::vector<std::vector<std::uint64_t>> sets_;  // [largest][fingers]: see tendon_sets
  std::uint64_t total_ = 0;

  std::vector<ShapeCursor> tendons_;  // the first depth_ are in use, the others lend their memory
  std::size_t depth_ = 0;
  int open_fingers_ = 0;  // number of fingers not yet on a tendon
  Numbering numbering_;
  Routing current_;

  enum class Position { before_first, at_unread, at_read, behind_last };
  Position position_ = Position::before_first;
  StopCheck check_;
};

}  // namespace reeve::search
