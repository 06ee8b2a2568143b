// An SQLite file that is a store of ours, and what goes wrong with such files said as input errors.
#pragma once

#include <SQLiteCpp/Database.h>
#include <SQLiteCpp/Exception.h>
#include <SQLiteCpp/Statement.h>

#include <cstdint>
#include <filesystem>
#include <string>

#include "numerics/floors.hpp"

namespace reeve::store {

// A reader that just closes holds a lock for a moment.
inline constexpr int patience_ms = 1000;

enum class Access : std::uint8_t { read, write };

// Throws InputError that names the file and what SQLite said of it.
[[noreturn]] void fail(const std::filesystem::path& file, const SQLite::Exception& error);

// Runs `action`; what SQLite throws becomes an InputError.
template <typename Action>
auto in_database(const std::filesystem::path& file, Action action) {
  try {
    return action();
  } catch (const SQLite::Exception& error) {
    fail(file, error);
  }
}

// The file, opened. Nothing of it changes here but that one for writing is made where there is
// none. Throws InputError if it is no store of this version; `is_new` tells whether it is empty.
struct OpenedStore {
  SQLite::Database database;
  bool is_new = false;
};
OpenedStore open_store(const std::filesystem::path& file, Access access);

// SQLite's whole numbers have a sign. Throws InputError beyond 2^63.
std::int64_t whole_number(std::uint64_t number);

}  // namespace reeve::store
