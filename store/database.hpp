// An SQLite file that is a store of ours, and what goes wrong with such files said as input errors.
#pragma once

#include <SQLiteCpp/Database.h>
#include <SQLiteCpp/Exception.h>
#include <SQLiteCpp/Statement.h>

#include <cstdint>
#include <filesystem>
#include <optional>

#include "numerics/floors.hpp"

namespace reeve::store {

// At most one process writes a store, from its first transaction to its last. SQLite's own lock is
// let go between two of them, where who waits for it could step in.
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

// A reader that just closes holds a lock for a moment.
inline constexpr int patience_ms = 1000;

enum class Access : std::uint8_t { read, write };

// Throws InputError that names the file and what SQLite said of it, or std::bad_alloc.
[[noreturn]] void fail(const std::filesystem::path& file, const SQLite::Exception& error);

// Runs `action`; what SQLite throws becomes an InputError, or std::bad_alloc.
template <typename Action>
auto in_database(const std::filesystem::path& file, Action action) {
  try {
    return action();
  } catch (const SQLite::Exception& error) {
    fail(file, error);
  }
}

// The store in the file, opened to read: nothing of the file changes, but that a transaction which
// a killed process left half written is undone. Nothing if one may be made there (Access::write).
// Throws InputError if it is no store of this version.
std::optional<SQLite::Database> open_store(const std::filesystem::path& file, Access access);

// The file, which is there and may be empty.
SQLite::Database open_to_write(const std::filesystem::path& file);

// Throws SQLite::Exception if the file has faults that only who writes it would meet, such as in
// its list of free pages.
void require_sound(SQLite::Database& database);

// SQLite's whole numbers have a sign. Throws InputError beyond 2^63.
std::int64_t whole_number(std::uint64_t number);

}  // namespace reeve::store
