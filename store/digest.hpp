// Digest that shows if rows are still as written. SQLite notices a torn page, but neither a flipped
// bit within a value nor a changed row. (Fowler, Noll, Vo: FNV-1a, 64 bit.)
#pragma once

#include <SQLiteCpp/Database.h>
#include <SQLiteCpp/Statement.h>

#include <cstdint>
#include <string_view>

#include "search/explore.hpp"

namespace reeve::store {

// Digest of values in their order, each with its kind.
class Digest {
 public:
  void add(std::int64_t number);
  void add(double number);
  void add(std::string_view text);
  void add_null();

  std::uint64_t value() const { return value_; }

 private:
  void add_bits(unsigned char kind, std::uint64_t bits);
  void add_byte(std::uint64_t byte);

  std::uint64_t value_ = 0xcbf29ce484222325;
};

// Covers the shard's rows in all tables but `designs`, its counts, and the request. Rows of another
// exploration thus do not match.
std::uint64_t digest_of_shard(SQLite::Database& database, std::int64_t shard);

// Digest of a row of `designs`, as written and as read. The digests of many rows are added up, so
// that neither their order nor their shard matters.
std::uint64_t digest_of(const EvaluatedDesign& design);
std::uint64_t digest_of_row(SQLite::Statement& row);

}  // namespace reeve::store
