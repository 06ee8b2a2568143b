// The routings of a set of parts that have floating blocks, one after the other, each once.
//
// A routing is a set of trees that each have a block, and tendons without blocks beside them
// (tendon_generator.hpp). Fewer blocks come first, then more fingers on the trees that have them;
// then the sets of trees follow by their indices (tree_sets.hpp), and with each the tendons. So
// nothing seen is remembered, nothing is made to be thrown away, and `seek` reckons where to begin.
// The words are canonical; their order is not that of canonical.hpp.
#pragma once

#include <cstdint>
#include <vector>

#include "search/enumerate/tendon_generator.hpp"
#include "search/enumerate/tree_index.hpp"
#include "search/enumerate/tree_sets.hpp"

namespace reeve::search {

// The words of trees: from an index to tendons in the order of core/canonical_tree.hpp.
//
// Each tendon is walked the way that makes the lesser word, by its tokens and, where these read the
// same both ways, with the lesser branch first; the tendons stand level by level, and the blocks
// are numbered as they appear. So with identical fingers what is written is canonical. Blocks in
// series are left to core's canonical(), and so are distinct fingers, whose numbers decide, too.
// Tendons one after the other; keeps the memory of those no longer in use.
struct TendonList {
  std::vector<Tendon> tendons;
  std::size_t used = 0;

  Tendon& add() {
    if (used == tendons.size()) tendons.emplace_back();
    return tendons[used++];
  }
};

class TreeWriter {
 public:
  explicit TreeWriter(const TreeDecoder& decoder) : decoder_(decoder) {
    branches_.reserve(max_generated_blocks);
  }

  // Appends the tree's tendons. Blocks, and bars likewise, are numbered from 1, fingers not at all
  // (identical) or as the index says.
  void write(const TreeIndex& tree, TendonList& list);

 private:
  void write_below(std::vector<TreeIndex>& branches, TendonList& list, std::size_t from = 0);
  void write_risers(TendonList& list);
  void write_tendon(SplitTendon& tendon, int own_block, std::vector<TreeIndex>& branches,
                    TendonList& list);
  void join_halves(const SplitTendon& split, Tendon& tendon) const;
  bool stands_backwards(const SplitTendon& tendon, const Walk& walk) const;
  bool precedes(const TreeIndex& a, const TreeIndex& b) const;

  const TreeDecoder& decoder_;
  SplitTendon tendon_;
  std::vector<TreeIndex> branches_;
};

class TreeGenerator {
 public:
  // Routings whose trees with blocks have this size in all.
  struct Cell {
    TreeSize size;
    std::uint64_t sets = 0;     // number of sets of trees, on any of the fingers
    std::uint64_t tendons = 0;  // number of routings of the other fingers
  };

  // Throws InputError if there are too many to count.
  explicit TreeGenerator(const GeneratorOptions& options);
  // Its parts point at each other.
  TreeGenerator(const TreeGenerator&) = delete;
  TreeGenerator& operator=(const TreeGenerator&) = delete;

  std::uint64_t total() const { return total_; }

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
  std::uint64_t sets_of(TreeSize size) const;
  TendonGenerator& others(const Cell& cell);
  void start_set();
  void decode_set();
  void list_trees();
  bool precedes(const Span& a, const Span& b) const;
  void advance();
  void write(Routing& routing);
  void append_tree(const Span& span, std::size_t& tendon, BlockCount& blocks,
                   Routing& routing) const;
  void number_others();

  GeneratorOptions options_;
  TreeCounts counts_;
  TreeDecoder decoder_;
  TreeWriter writer_;
  TreeSets sets_;
  std::vector<TendonGenerator> others_;  // [fingers - 1]
  std::vector<Cell> cells_;
  std::uint64_t total_ = 0;

  std::size_t cell_ = 0;
  std::uint64_t set_ = 0;
  std::uint64_t tendons_ = 0;  // the index of the routing of the other fingers
  bool set_is_listed_ = false;
  std::vector<TreeIndex> trees_;
  TendonList list_;
  std::vector<Span> spans_;
  FingerSet other_fingers_ = 0;
  Routing beside_;
};

}  // namespace reeve::search
