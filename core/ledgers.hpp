// Ledgers hold what all walks of a word must add up to: fingers without a gap, each passed once
// or tied once or twice; motors
// without a gap; blocks and bars that are whole and do not hang on themselves.
#pragma once

#include <array>

#include "core/word.hpp"

namespace reeve::core {

class FingerLedger {
 public:
  explicit FingerLedger(const Word& word) : word_(word) {}

  // These throw InputError.
  void pass(const PlacedWalk& walk);
  void require_no_gap() const;

 private:
  struct Entry {
    bool passed = false;
    int ends = 0;
    int extensors = 0;
  };

  [[noreturn]] void refuse(const PlacedToken& placed, const char* what) const;

  Word word_;
  std::array<Entry, max_fingers + 1> entries_{};
  int highest_ = 0;
  int second_tendons_ = 0;
};

class CarriageLedger {
 public:
  explicit CarriageLedger(const Word& word) : word_(word) {}

  void pass(const PlacedWalk& walk);
  void require_no_gap() const;  // throws InputError

 private:
  Word word_;
  std::array<bool, max_carriages + 1> named_{};
  int highest_ = 0;
};

class BlockLedger {
 public:
  explicit BlockLedger(const Word& word) : word_(word) {}

  // These throw InputError.
  void pass(const PlacedWalk& walk);
  void require_whole(const Routing& routing) const;

 private:
  struct Entry {
    bool named = false;
    bool tail = false;
    bool pulled = false;  // has a pass, a becket or arms
    PlacedText at{};
  };

  void require_parts(std::size_t key) const;
  void require_no_ring(const Routing& routing) const;

  Word word_;
  std::array<Entry, block_keys> entries_{};
  bool any_named_ = false;
};

}  // namespace reeve::core
