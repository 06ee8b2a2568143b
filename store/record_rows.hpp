// Rows of a store: its exploration, what it keeps, and the record of each shard. The routings of a
// record count: a reader evaluates them again. The objectives beside them are for people.
#pragma once

#include <SQLiteCpp/Database.h>

#include <cstdint>
#include <filesystem>
#include <optional>
#include <vector>

#include "search/exploration_part.hpp"
#include "search/explore.hpp"
#include "store/description.hpp"
#include "store/exploration_store.hpp"

namespace reeve::store {

void write_about(SQLite::Database& database, const Description& description, Keep keep);

// Without names of known routings and texts of constraints, which stand with their counts.
Description read_description(SQLite::Database& database);
Keep read_keep(SQLite::Database& database);

// Replaces the rows of the shard. `designs_digest` is the digest of the rows of `designs` added
// since the last time.
void write_record(SQLite::Database& database, const Shard& shard, ExplorationPart& part,
                  const Description& description, std::uint64_t designs_digest);

// Throws InputError that names the file if its rows are not those that write_record() and
// ExplorationStore::add() left, or belong to a shard that has not begun.
void require_as_written(SQLite::Database& database, const std::filesystem::path& file);

// Returns nothing if the shard has not begun.
std::optional<ShardRecord> read_record(SQLite::Database& database, std::uint64_t shard);

// Returns the shards that have begun, by number.
std::vector<Shard> stored_shards(SQLite::Database& database);

}  // namespace reeve::store
