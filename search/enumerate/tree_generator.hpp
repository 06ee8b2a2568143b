// The routings of a set of parts that have floating blocks, one after the other, each once.
//
// A routing is a set of trees that each have a block, and tendons without blocks beside them
// (tendon_generator.hpp). Fewer blocks come first, then more fingers on the trees that have them;
// then the sets of trees follow by their indices (tree_grammar.hpp), and with each the tendons. So
// nothing seen is remembered, nothing is made to be thrown away, and `seek` reckons where to begin.
// The words are canonical; their order is not that of canonical.hpp.
#pragma once

#include <cstdint>
#include <deque>
#include <vector>

#include "search/enumerate/tendon_generator.hpp"
#include "search/enumerate/tree_grammar.hpp"
#include "search/enumerate/tree_writer.hpp"

namespace reeve::search {

class TreeGenerator {
 public:
  // Routings whose trees with blocks have this size in all.
  struct Cell {
    TreeSize size;
    Grammar::Sort of_sets{};    // sets of trees
    std::uint64_t sets = 0;     // number of sets of trees, on any of the fingers
    std::uint64_t tendons = 0;  // number of routings of the other fingers
  };

  // Throws InputError if there are too many to count.
  explicit TreeGenerator(const GeneratorOptions& options);
  // Its parts point at each other.
  TreeGenerator(const TreeGenerator&) = delete;
  TreeGenerator& operator=(const TreeGenerator&) = delete;

  std::uint64_t total() const { return total_; }
  const Grammar& grammar() const { return grammar_.grammar(); }

  // The next call of next() gives the routing of this index, from 0.
  void seek(std::uint64_t index);

  // False when all have been given. Keeps the memory of `routing`.
  bool next(Routing& routing);

  // Returns the cells in the order of the routings. A cell's sets follow by their indices, and with
  // each the routings of the other fingers.
  const std::vector<Cell>& cells() const { return cells_; }
  // The routing of a cell's set of trees and of such a one, which the cell may not have; where
  // next() stands does not survive it.
  void make(std::size_t cell, std::uint64_t set, const Routing& of_others, Routing& routing);

 private:
  // A tree's part of the list.
  struct Span {
    int fingers = 0;
    std::size_t begin = 0;
    std::size_t end = 0;
  };

  void add_cell(TreeSize size);
  TendonGenerator& others(const Cell& cell);
  void start_set();
  void list_set();
  void list_trees(const Grammar::Thing& set);
  bool precedes(const Span& a, const Span& b) const;
  void advance();
  void write(Routing& routing);
  void append_tree(const Span& span, std::size_t& tendon, BlockCount& blocks,
                   Routing& routing) const;
  void number_others();

  GeneratorOptions options_;
  TreeGrammar grammar_;
  TreeWriter writer_;
  std::deque<TendonGenerator> others_;  // [fingers - 1]
  std::vector<Cell> cells_;
  std::uint64_t total_ = 0;

  std::size_t cell_ = 0;
  std::uint64_t set_ = 0;
  std::uint64_t tendons_ = 0;  // the index of the routing of the other fingers
  bool set_is_listed_ = false;
  TendonList list_;
  std::vector<Span> spans_;
  FingerSet other_fingers_ = 0;
  Routing beside_;
};

}  // namespace reeve::search
