#include "store/store_reader.hpp"

#include <fmt/format.h>

#include <optional>
#include <utility>

#include "core/error.hpp"
#include "store/database.hpp"
#include "store/record_rows.hpp"
#include "store/schema.hpp"

namespace reeve::store {

struct StoreReader::Connection {
  SQLite::Database database;
};

StoreReader::StoreReader(std::filesystem::path file)
    : file_(std::move(file)),
      connection_(
          std::make_unique<Connection>(Connection{open_store(file_, Access::read).value()})) {
  in_database(file_, [&] {
    SQLite::Database& database = connection_->database;
    // The transaction makes all reads see one state.
    database.exec("BEGIN");
    description_ = read_description(database);
    keep_ = read_keep(database);
  });
}

StoreReader::~StoreReader() = default;

std::vector<StoredShard> StoreReader::shards() const {
  return in_database(file_, [&] {
    SQLite::Database& database = connection_->database;
    std::vector<StoredShard> shards;
    for (const Shard& shard : stored_shards(database)) {
      std::optional<ShardRecord> record = read_record(database, shard.index);
      const bool is_one =
          record && record->evaluated <= record->generated && record->generated <= record->total;
      if (!is_one) {
        throw InputError({.where = file_.string(),
                          .what = fmt::format("shard {} of {}", shard.index, shard.count),
                          .expected = "counts of routings that can be"});
      }
      shards.push_back({shard, std::move(*record)});
    }
    if (shards.empty()) {
      throw InputError({.where = file_.string(),
                        .what = "explore has saved nothing in it yet",
                        .expected = "a store after its first save",
                        .form = InputForm::unknown});
    }
    require_as_written(database, file_);
    return shards;
  });
}

void StoreReader::for_each_design(const std::function<void(const EvaluatedDesign&)>& visit) const {
  in_database(file_, [&] {
    SQLite::Statement query(
        connection_->database,
        fmt::format("SELECT place, routing{} FROM designs ORDER BY place", objective_columns()));
    while (query.executeStep()) {
      visit({static_cast<std::uint64_t>(query.getColumn(0).getInt64()),
             query.getColumn(1).getString(), objectives_of(query, 2)});
    }
  });
}

void StoreReader::for_each_archived(const std::function<void(const ArchivedDesign&)>& visit) const {
  in_database(file_, [&] {
    SQLite::Statement query(
        connection_->database,
        fmt::format("SELECT routing, equals_left_out{} FROM archive ORDER BY shard, number",
                    objective_columns()));
    while (query.executeStep()) {
      visit({{query.getColumn(0).getString(), objectives_of(query, 2)},
             static_cast<std::uint64_t>(query.getColumn(1).getInt64())});
    }
  });
}

void StoreReader::for_each_step(const std::function<void(const Design&)>& visit) const {
  in_database(file_, [&] {
    SQLite::Statement query(
        connection_->database,
        fmt::format("SELECT routing{} FROM tradeoff ORDER BY shard, number", objective_columns()));
    while (query.executeStep()) {
      visit({query.getColumn(0).getString(), objectives_of(query, 1)});
    }
  });
}

}  // namespace reeve::store
