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

// Lock that lets one process write a store, from its first transaction to its last. SQLite's own
// lock is released between two transactions, and a waiting process could then get it.
//
// Readers do not need the lock. Destroy it after the connection to the file: closing a file
// releases all locks that SQLite holds on it in this process.
class WriterLock {
 public:
  // Creates the file if there is none. Throws InputError if another process has the lock. Takes no
  // lock if the file system has none, or if nothing can be written.
  explicit WriterLock(const std::filesystem::path& file);
  WriterLock(const WriterLock&) = delete;
  WriterLock& operator=(const WriterLock&) = delete;
  ~WriterLock();

  // True if the name still leads to the locked file, or if no lock is held.
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

// Throws SQLite::Exception if the file has faults that only writing would meet, such as in its list
// of free pages.
void require_sound(SQLite::Database& database);

// SQLite's whole numbers have a sign. Throws InputError beyond 2^63.
std::int64_t whole_number(std::uint64_t number);

}  // namespace reeve::store
