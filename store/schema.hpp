// The tables of a store, docs/store.md for people. A change to them is a new schema_version.
#pragma once

#include <SQLiteCpp/Database.h>
#include <SQLiteCpp/Statement.h>

#include <array>
#include <string>

#include "search/evaluate/objectives.hpp"

namespace reeve::store {

inline constexpr int application_id = 0x72656576;  // "reev"
inline constexpr int schema_version = 6;

// The tables of which each row belongs to a shard, by its first column.
inline constexpr std::array shard_tables{"constraints", "known", "archive", "tradeoff", "sample"};

void create_tables(SQLite::Database& database);

// True if the tables are there as create_tables() makes them, and nothing else, such as a trigger.
bool has_tables(SQLite::Database& database);

// ", uniformity_mean, …": every objective, and as many question marks.
std::string objective_columns();
std::string objective_marks();

// An objective that the design does not have (of a hand, where there is none; a cost without
// prices) is NULL.
bool is_stored(const ObjectiveRow& row, const ObjectiveValues& values);
void bind_objectives(SQLite::Statement& statement, int first, const ObjectiveValues& values);
ObjectiveValues objectives_of(SQLite::Statement& row, int first);

}  // namespace reeve::store
