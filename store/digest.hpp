// What tells whether rows are still those that were written: SQLite notices a torn page, and
// neither a flipped bit within a value nor a row that somebody changed. (Fowler, Noll, Vo: FNV-1a,
// 64 bit.)
#pragma once

#include <SQLiteCpp/Database.h>
#include <SQLiteCpp/Statement.h>

#include <cstdint>
#include <string_view>

#include "search/explore.hpp"

namespace reeve::store {

// Of values in their order, each with its kind.
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

// Of the shard's rows in all tables but `designs`, of its counts, and of what was asked, so that
// rows of another exploration are none of this.
std::uint64_t digest_of_shard(SQLite::Database& database, std::int64_t shard);

// Of a row of `designs`, as it is written and as it is read. Those of many rows are added up, so
// that their order, and which shard they are of, does not matter.
std::uint64_t digest_of(const EvaluatedDesign& design);
std::uint64_t digest_of_row(SQLite::Statement& row);

}  // namespace reeve::store
