// At most one process writes a store, from its first transaction to its last. SQLite's own lock is
// let go between two of them, where who waits for it could step in.
#pragma once

#include <filesystem>

#include "numerics/floors.hpp"

namespace reeve::store {

// Held as long as it lives; readers do not meet it. To be destroyed after the connection to the
// file: when a file is closed, all that SQLite has locked of it in this process is let go.
class WriterLock {
 public:
  // Makes the file where there is none. Throws InputError if another process has it. Where the file
  // system knows no such lock, or nothing can be written, there is none.
  explicit WriterLock(const std::filesystem::path& file);
  WriterLock(const WriterLock&) = delete;
  WriterLock& operator=(const WriterLock&) = delete;
  ~WriterLock();

  // Whether the name still leads to the file that was locked, or no lock is held.
  bool is_on(const std::filesystem::path& file) const;

 private:
  int descriptor_ = -1;
};

}  // namespace reeve::store
