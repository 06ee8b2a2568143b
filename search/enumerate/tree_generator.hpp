// The routings of a set of parts within limits that have floating blocks, one after the other, each
// once and at their places among all.
//
// A routing is a set of trees that each have a block, and tendons without blocks beside them
// (tendon_generator.hpp). Fewer blocks come first, then more fingers on the trees that have them;
// then the sets of trees follow by their indices (tree_grammar.hpp), and with each the tendons. So
// nothing seen is remembered, nothing is made to be thrown away, and `seek` reckons where to begin.
// Sets of trees that leave the tendons beside them no way to stay within the limits are passed over
// by their numbers (limits/numbered_parts.hpp); beside the others only such tendons are tried.
//
// The words are canonical; their order is not that of canonical.hpp.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "search/enumerate/tendon_generator.hpp"
#include "search/enumerate/tree_grammar.hpp"
#include "search/enumerate/tree_writer.hpp"
#include "search/limits/numbered_parts.hpp"

namespace reeve::search {

class TreeGenerator {
 public:
  // Keeps a reference to the classes, which set no limits to distinct fingers. Throws InputError if
  // there are too many to count.
  TreeGenerator(const GeneratorOptions& options, const PartClasses& classes);
  // Its parts point at each other.
  TreeGenerator(const TreeGenerator&) = delete;
  TreeGenerator& operator=(const TreeGenerator&) = delete;

  std::uint64_t total() const { return total_; }

  // The next call of next() gives the first routing from this index on that is within the limits.
  void seek(std::uint64_t index);

  // False when all have been given. Keeps the memory of `routing`.
  bool next(Routing& routing, std::uint64_t& index);

  // Counts the routings with an index below this one. Fingers must be identical.
  ClassCounts counts_before(std::uint64_t index);

  // Returns the index of a canonical routing with blocks, whatever its parts, if it is in the
  // enumeration. Searches the routings whose trees have as many parts; seek() again afterwards.
  std::optional<std::uint64_t> index_of(const Routing& routing);

  // Returns the number of sets of trees and tendons examined.
  std::uint64_t steps() { return steps_ + beside_.shapes().steps(); }

  void stop_with(const StopCheck& check) { beside_.shapes().stop_with(check); }

 private:
  // Routings whose trees with blocks have this size in all. A cell's sets follow by their indices,
  // and with each the routings of the other fingers.
  struct Cell {
    TreeSize size;
    int others = 0;              // number of the other fingers
    Grammar::Sort of_sets{};     // sets of trees
    std::uint64_t sets = 0;      // number of sets of trees, on any of the fingers
    std::uint64_t tendons = 0;   // number of routings of the other fingers
    std::uint64_t begin = 0;     // index of its first routing
    NumberedParts::Goal goal{};  // limit on the sets
  };

  // A tree's part of the list.
  struct Span {
    int fingers = 0;
    std::size_t begin = 0;
    std::size_t end = 0;
  };

  const Grammar& grammar() const { return grammar_.grammar(); }
  bool has_limits() const { return classes_.count() > 1; }
  void add_cell(TreeSize size);
  NumberedParts::Goal goal(int others);
  void start_set(NumberedParts::Found set, std::uint64_t beside);
  bool next_set();
  bool next_beside(std::uint64_t& index);
  void list_set(std::uint64_t set);
  void list_trees(const Grammar::Thing& set);
  bool precedes(const Span& a, const Span& b) const;
  void write(Routing& routing);
  void append_tree(const Span& span, std::size_t& tendon, BlockCount& blocks,
                   Routing& routing) const;
  void number_others();

  GeneratorOptions options_;
  const PartClasses& classes_;
  TreeGrammar grammar_;
  TreeWriter writer_;
  NumberedParts parts_;
  TendonGenerator beside_;
  std::vector<Cell> cells_;
  std::uint64_t total_ = 0;

  std::size_t cell_ = 0;
  std::uint64_t next_set_ = 0;
  std::optional<std::uint64_t> set_;  // the set being listed
  bool is_alone_ = false;             // true if its trees have all fingers and it is unread
  std::uint64_t steps_ = 0;
  TendonList list_;
  std::vector<Span> spans_;
  FingerSet other_fingers_ = 0;
  Routing of_others_;
};

}  // namespace reeve::search
