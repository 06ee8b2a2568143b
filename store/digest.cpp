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

void add_rows(SQLite::Statement rows, Digest& digest) {
  while (rows.executeStep()) add_row(rows, digest);
}

SQLite::Statement rows_of_shard(SQLite::Database& database, const std::string& sql,
                                std::int64_t shard) {
  SQLite::Statement rows(database, sql);
  rows.bind(1, shard);
  return rows;
}

}  // namespace

void Digest::add(std::int64_t number) { add_bits('i', static_cast<std::uint64_t>(number)); }

// SQLite keeps no sign of a zero, and no number that is none.
void Digest::add(double number) {
  if (std::isnan(number)) return add_null();
  add_bits('r', std::bit_cast<std::uint64_t>(number == 0 ? 0 : number));
}

void Digest::add(std::string_view text) {
  add_bits('t', text.size());
  for (const char byte : text) add_byte(static_cast<unsigned char>(byte));
}

void Digest::add_null() { add_byte('0'); }

void Digest::add_bits(unsigned char kind, std::uint64_t bits) {
  add_byte(kind);
  for (int byte = 0; byte < 8; ++byte) add_byte(bits >> (8 * byte) & 0xffU);
}

void Digest::add_byte(std::uint64_t byte) { value_ = (value_ ^ byte) * fnv_prime; }

std::uint64_t digest_of_shard(SQLite::Database& database, std::int64_t shard) {
  Digest digest;
  for (const char* table : {"about", "settings"}) {
    add_rows({database, fmt::format("SELECT key, value FROM {} ORDER BY key", table)}, digest);
  }
  add_rows(
      rows_of_shard(
          database,
          "SELECT shard, shards, total, generated, evaluated, without_tensions, "
          "example_without_tensions, unconverged, seconds, designs_digest FROM shards WHERE shard = ?",
          shard),
      digest);
  for (const char* table : shard_tables) {
    // Rows are sorted by number; those of the sample, by place.
    add_rows(
        rows_of_shard(database, fmt::format("SELECT * FROM {} WHERE shard = ? ORDER BY 2", table),
                      shard),
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
