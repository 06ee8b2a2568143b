#include "store/digest.hpp"

#include <fmt/format.h>
#include <sqlite3.h>

#include <bit>
#include <cmath>
#include <string>

#include "store/database.hpp"
#include "store/schema.hpp"

namespace reeve::store {
namespace {

constexpr std::uint64_t fnv_prime = 0x100000001b3;

template <typename Number>
std::string_view bytes_of(const Number& number) {
  return {reinterpret_cast<const char*>(&number), sizeof number};
}

void add_row(SQLite::Statement& row, Digest& digest) {
  for (int i = 0; i < row.getColumnCount(); ++i) {
    const SQLite::Column cell = row.getColumn(i);
    switch (cell.getType()) {
      case SQLITE_INTEGER:
        digest.add(cell.getInt64());
        break;
      case SQLITE_FLOAT:
        digest.add(cell.getDouble());
        break;
      case SQLITE_NULL:
        digest.add_null();
        break;
      default:
        digest.add(std::string_view(cell.getString()));
    }
  }
}

void add_rows(SQLite::Database& database, const std::string& sql, std::int64_t shard,
              Digest& digest) {
  SQLite::Statement rows(database, sql);
  rows.bind(1, shard);
  while (rows.executeStep()) add_row(rows, digest);
}

}  // namespace

void Digest::add(std::int64_t number) { add_bytes('i', bytes_of(number)); }

// SQLite keeps no sign of a zero, and no number that is none.
void Digest::add(double number) {
  if (std::isnan(number)) return add_null();
  const double kept = number == 0 ? 0 : number;
  add_bytes('r', bytes_of(kept));
}

void Digest::add(std::string_view text) {
  add(static_cast<std::int64_t>(text.size()));
  add_bytes('t', text);
}

void Digest::add_null() { add_bytes('0', {}); }

void Digest::add_bytes(char kind, std::string_view bytes) {
  const auto fold = [this](char byte) {
    value_ = (value_ ^ static_cast<unsigned char>(byte)) * fnv_prime;
  };
  fold(kind);
  for (const char byte : bytes) fold(byte);
}

std::uint64_t digest_of_shard(SQLite::Database& database, std::int64_t shard) {
  Digest digest;
  add_rows(database,
           "SELECT shard, shards, total, generated, evaluated, unconverged, seconds, "
           "designs_digest FROM shards WHERE shard = ?",
           shard, digest);
  for (const char* table : {"constraints", "known", "archive", "ladder", "sample"}) {
    // By number, or of the sample by place.
    add_rows(database, fmt::format("SELECT * FROM {} WHERE shard = ? ORDER BY 2", table), shard,
             digest);
  }
  return digest.value();
}

std::uint64_t digest_of(const EvaluatedDesign& design) {
  Digest digest;
  digest.add(whole_number(design.place));
  digest.add(std::string_view(design.word));
  for (const ObjectiveRow& row : objective_table()) {
    if (is_stored(row, design.values)) {
      digest.add(value(design.values, row.objective));
    } else {
      digest.add_null();
    }
  }
  return digest.value();
}

std::uint64_t digest_of_row(SQLite::Statement& row) {
  Digest digest;
  add_row(row, digest);
  return digest.value();
}

}  // namespace reeve::store
