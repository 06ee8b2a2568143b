#include "store/schema.hpp"

#include <fmt/format.h>

#include <cmath>
#include <limits>

namespace reeve::store {
namespace {

constexpr const char* tables = R"(
CREATE TABLE about (key TEXT PRIMARY KEY, value TEXT NOT NULL) WITHOUT ROWID;
CREATE TABLE settings (key TEXT PRIMARY KEY, value TEXT NOT NULL) WITHOUT ROWID;
CREATE TABLE shards (shard INTEGER PRIMARY KEY, shards INTEGER NOT NULL, total INTEGER NOT NULL,
  generated INTEGER NOT NULL, evaluated INTEGER NOT NULL,
  without_tensions INTEGER NOT NULL, example_without_tensions TEXT NOT NULL, unconverged INTEGER NOT NULL,
  seconds REAL NOT NULL, designs_digest INTEGER NOT NULL, digest INTEGER NOT NULL);
CREATE TABLE constraints (shard INTEGER NOT NULL, number INTEGER NOT NULL, text TEXT NOT NULL,
  failures INTEGER NOT NULL, met INTEGER NOT NULL, nearest_below REAL, nearest_above REAL,
  nearest_below_others_met REAL, nearest_above_others_met REAL,
  PRIMARY KEY (shard, number)) WITHOUT ROWID;
CREATE TABLE known (shard INTEGER NOT NULL, number INTEGER NOT NULL, name TEXT NOT NULL,
  dominated_by INTEGER NOT NULL, generated INTEGER NOT NULL, rejected_by INTEGER,
  PRIMARY KEY (shard, number)) WITHOUT ROWID;
CREATE TABLE sample (shard INTEGER NOT NULL, place INTEGER NOT NULL, routing TEXT NOT NULL,
  PRIMARY KEY (shard, place)) WITHOUT ROWID;
)";

std::string objective_definitions() {
  std::string text;
  for (const ObjectiveRow& row : objective_table()) text += fmt::format(", {} REAL", row.name);
  return text;
}

}  // namespace

void create_tables(SQLite::Database& database) {
  const std::string objectives = objective_definitions();
  database.exec(tables);
  database.exec(
      fmt::format("CREATE TABLE archive (shard INTEGER NOT NULL, number INTEGER NOT NULL, "
                  "routing TEXT NOT NULL, equals_left_out INTEGER NOT NULL{}, "
                  "PRIMARY KEY (shard, number)) WITHOUT ROWID",
                  objectives));
  database.exec(
      fmt::format("CREATE TABLE tradeoff (shard INTEGER NOT NULL, number INTEGER NOT NULL, "
                  "routing TEXT NOT NULL{}, PRIMARY KEY (shard, number)) WITHOUT ROWID",
                  objectives));
  database.exec(fmt::format(
      "CREATE TABLE designs (place INTEGER PRIMARY KEY, routing TEXT NOT NULL{})", objectives));
  database.exec(fmt::format("PRAGMA application_id = {}; PRAGMA user_version = {}", application_id,
                            schema_version));
}

bool has_tables(SQLite::Database& database) {
  SQLite::Database made(":memory:", SQLite::OPEN_READWRITE | SQLite::OPEN_CREATE);
  create_tables(made);
  constexpr const char* count = "SELECT count(*) FROM sqlite_master";
  if (made.execAndGet(count).getInt() != database.execAndGet(count).getInt()) return false;
  SQLite::Statement table(made, "SELECT name, sql FROM sqlite_master");
  SQLite::Statement there(database, "SELECT 1 FROM sqlite_master WHERE name = ? AND sql = ?");
  while (table.executeStep()) {
    there.reset();
    there.bind(1, table.getColumn(0).getString());
    there.bind(2, table.getColumn(1).getString());
    if (!there.executeStep()) return false;
  }
  return true;
}

std::string objective_columns() {
  std::string text;
  for (const ObjectiveRow& row : objective_table()) text += fmt::format(", {}", row.name);
  return text;
}

std::string objective_marks() {
  std::string text;
  for (std::size_t i = 0; i < objective_count; ++i) text += ", ?";
  return text;
}

bool is_stored(const ObjectiveRow& row, const ObjectiveValues& values) {
  if (row.objective == Objective::cost) return std::isfinite(value(values, Objective::cost));
  return is_there(row, values);
}

void bind_objectives(SQLite::Statement& statement, int first, const ObjectiveValues& values) {
  for (const ObjectiveRow& row : objective_table()) {
    if (is_stored(row, values)) {
      statement.bind(first, value(values, row.objective));
    } else {
      statement.bind(first);
    }
    ++first;
  }
}

ObjectiveValues objectives_of(SQLite::Statement& row, int first) {
  ObjectiveValues values{};
  for (const ObjectiveRow& objective : objective_table()) {
    const SQLite::Column column = row.getColumn(first++);
    const bool is_cost = objective.objective == Objective::cost;
    const double missing = is_cost ? std::numeric_limits<double>::infinity() : 0;
    value(values, objective.objective) = column.isNull() ? missing : column.getDouble();
  }
  return values;
}

}  // namespace reeve::store
