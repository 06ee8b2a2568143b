#include "store/record_rows.hpp"

#include <SQLiteCpp/Statement.h>
#include <fmt/format.h>

#include <string>

#include "core/error.hpp"
#include "core/notation.hpp"
#include "store/database.hpp"
#include "store/digest.hpp"
#include "store/schema.hpp"

namespace reeve::store {
namespace {

void write_pairs(SQLite::Database& database, const std::string& table,
                 const std::vector<StoredSetting>& pairs) {
  SQLite::Statement insert(database, fmt::format("INSERT INTO {} VALUES (?, ?)", table));
  for (const StoredSetting& pair : pairs) {
    insert.reset();
    insert.bind(1, pair.key);
    insert.bind(2, pair.value);
    insert.exec();
  }
}

std::string about(SQLite::Database& database, const std::string& key) {
  SQLite::Statement query(database, "SELECT value FROM about WHERE key = ?");
  query.bind(1, key);
  return query.executeStep() ? query.getColumn(0).getString() : "";
}

// A statement that is run for row after row of one shard.
class RowWriter {
 public:
  RowWriter(SQLite::Database& database, const std::string& sql, std::int64_t shard)
      : statement_(database, sql), shard_(shard) {}

  RowWriter& row() {
    statement_.reset();
    statement_.clearBindings();
    column_ = 0;
    return add(shard_);
  }
  RowWriter& add(std::int64_t number) { return statement_.bind(++column_, number), *this; }
  RowWriter& add(const std::string& text) { return statement_.bind(++column_, text), *this; }
  RowWriter& add(double number) { return statement_.bind(++column_, number), *this; }
  template <typename Value>
  RowWriter& add(const std::optional<Value>& maybe) {
    if (maybe) return add(*maybe);
    return ++column_, *this;
  }
  RowWriter& add(const ObjectiveValues& values) {
    return bind_objectives(statement_, column_ + 1, values), *this;
  }
  void write() { statement_.exec(); }

 private:
  SQLite::Statement statement_;
  std::int64_t shard_;
  int column_ = 0;
};

void write_constraints(SQLite::Database& database, std::int64_t shard, const ExplorationPart& part,
                       const Description& description) {
  RowWriter rows(database, "INSERT INTO constraints VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?)", shard);
  for (std::size_t c = 0; c < part.constraint_failures.size(); ++c) {
    const std::vector<ConstraintReach>& reaches = part.reaches.list();
    const ConstraintReach reach = c < reaches.size() ? reaches[c] : ConstraintReach{};
    rows.row().add(whole_number(c)).add(description.limits.at(c));
    rows.add(whole_number(part.constraint_failures[c])).add(std::int64_t{reach.met});
    rows.add(reach.of_all.below).add(reach.of_all.above);
    rows.add(reach.of_those_that_meet_the_others.below);
    rows.add(reach.of_those_that_meet_the_others.above).write();
  }
}

void write_known(SQLite::Database& database, std::int64_t shard, const ExplorationPart& part,
                 const Description& description) {
  RowWriter rows(database, "INSERT INTO known VALUES (?, ?, ?, ?, ?, ?)", shard);
  for (std::size_t r = 0; r < part.references.size(); ++r) {
    const ReferenceCount& known = part.references[r];
    std::optional<std::int64_t> rejected_by;
    if (known.rejected_by) rejected_by = whole_number(*known.rejected_by);
    rows.row().add(whole_number(r)).add(description.known.at(r));
    rows.add(whole_number(known.dominated_by)).add(std::int64_t{known.generated});
    rows.add(rejected_by).write();
  }
}

void write_designs(SQLite::Database& database, std::int64_t shard, ExplorationPart& part) {
  RowWriter archive(
      database, fmt::format("INSERT INTO archive VALUES (?, ?, ?, ?{})", objective_marks()), shard);
  std::uint64_t number = 0;
  for (const ArchivedDesign& member : part.archive.members()) {
    archive.row().add(whole_number(number++)).add(member.design.word);
    archive.add(whole_number(member.equals_left_out)).add(member.design.values).write();
  }
  RowWriter tradeoff(
      database, fmt::format("INSERT INTO tradeoff VALUES (?, ?, ?{})", objective_marks()), shard);
  number = 0;
  for (const Design& design : part.tradeoff.candidates()) {
    tradeoff.row().add(whole_number(number++)).add(design.word).add(design.values).write();
  }
  RowWriter sample(database, "INSERT INTO sample VALUES (?, ?, ?)", shard);
  for (const SampledRouting& sampled : part.sample.members()) {
    sample.row().add(whole_number(sampled.place)).add(to_word(sampled.routing)).write();
  }
}

SQLite::Statement rows_of(SQLite::Database& database, const std::string& columns,
                          const std::string& table, const std::string& order, std::uint64_t shard) {
  SQLite::Statement query(database, fmt::format("SELECT {} FROM {} WHERE shard = ? ORDER BY {}",
                                                columns, table, order));
  query.bind(1, whole_number(shard));
  return query;
}

std::uint64_t count_in(SQLite::Statement& row, int column) {
  return static_cast<std::uint64_t>(row.getColumn(column).getInt64());
}

// 0 if the shard has not begun.
std::uint64_t digest_in_shards(SQLite::Database& database, const char* column, std::int64_t shard) {
  SQLite::Statement row(database, fmt::format("SELECT {} FROM shards WHERE shard = ?", column));
  row.bind(1, shard);
  return row.executeStep() ? count_in(row, 0) : 0;
}

std::optional<double> bound_in(SQLite::Statement& row, int column) {
  const SQLite::Column cell = row.getColumn(column);
  return cell.isNull() ? std::nullopt : std::optional(cell.getDouble());
}

void read_counts(SQLite::Database& database, std::uint64_t shard, ShardRecord& record) {
  SQLite::Statement constraint =
      rows_of(database,
              "failures, met, nearest_above, nearest_below, nearest_above_others_met, "
              "nearest_below_others_met",
              "constraints", "number", shard);
  while (constraint.executeStep()) {
    record.constraint_failures.push_back(count_in(constraint, 0));
    record.reaches.push_back({constraint.getColumn(1).getInt() != 0,
                              {bound_in(constraint, 2), bound_in(constraint, 3)},
                              {bound_in(constraint, 4), bound_in(constraint, 5)}});
  }
  SQLite::Statement known =
      rows_of(database, "dominated_by, generated, rejected_by", "known", "number", shard);
  while (known.executeStep()) {
    ReferenceCount count{count_in(known, 0), known.getColumn(1).getInt() != 0, std::nullopt};
    if (!known.getColumn(2).isNull()) count.rejected_by = count_in(known, 2);
    record.references.push_back(count);
  }
}

void read_designs(SQLite::Database& database, std::uint64_t shard, ShardRecord& record) {
  SQLite::Statement archive =
      rows_of(database, "routing, equals_left_out", "archive", "number", shard);
  while (archive.executeStep()) {
    record.archive.push_back({archive.getColumn(0).getString(), count_in(archive, 1)});
  }
  SQLite::Statement tradeoff = rows_of(database, "routing", "tradeoff", "number", shard);
  while (tradeoff.executeStep()) record.steps.push_back(tradeoff.getColumn(0).getString());
  SQLite::Statement sample = rows_of(database, "place, routing", "sample", "place", shard);
  while (sample.executeStep()) {
    record.sample.push_back({count_in(sample, 0), sample.getColumn(1).getString()});
  }
}

[[noreturn]] void refuse_as_changed(const std::filesystem::path& file, const std::string& what,
                                    const std::string& expected) {
  throw InputError({.where = file.string(),
                    .what = what,
                    .expected = expected + ": the file is damaged, or was changed"});
}

// The digest of a shard says nothing of rows that belong to none.
void require_shards(SQLite::Database& database, const char* table,
                    const std::filesystem::path& file) {
  SQLite::Statement row(
      database,
      fmt::format("SELECT * FROM {} WHERE shard NOT IN (SELECT shard FROM shards)", table));
  if (!row.executeStep()) return;
  refuse_as_changed(
      file,
      fmt::format("the table {}, row shard = {}, {} = {}", table, row.getColumn(0).getString(),
                  row.getColumn(1).getName(), row.getColumn(1).getString()),
      "a shard of the table shards");
}

void require_designs(SQLite::Database& database, const std::filesystem::path& file) {
  std::uint64_t written = 0;
  SQLite::Statement digests(database, "SELECT designs_digest FROM shards");
  while (digests.executeStep()) written += count_in(digests, 0);
  std::uint64_t there = 0;
  SQLite::Statement designs(database, "SELECT * FROM designs");
  while (designs.executeStep()) there += digest_of_row(designs);
  if (there != written) refuse_as_changed(file, "the table designs", "what explore saved there");
}

}  // namespace

void write_about(SQLite::Database& database, const Description& description, Keep keep) {
  write_pairs(database, "about",
              {{"exploration", description.exploration},
               {"version", description.version},
               {"arguments", description.arguments},
               {"keep", keep == Keep::all ? "all" : "best"}});
  write_pairs(database, "settings", description.settings);
}

Description read_description(SQLite::Database& database) {
  Description description{
      about(database, "exploration"), about(database, "version"), about(database, "arguments"), {}};
  SQLite::Statement query(database, "SELECT key, value FROM settings ORDER BY key");
  while (query.executeStep()) {
    description.settings.push_back(
        {query.getColumn(0).getString(), query.getColumn(1).getString()});
  }
  return description;
}

Keep read_keep(SQLite::Database& database) {
  return about(database, "keep") == "all" ? Keep::all : Keep::best;
}

void write_record(SQLite::Database& database, const Shard& shard, ExplorationPart& part,
                  const Description& description, std::uint64_t designs_digest) {
  const std::int64_t index = whole_number(shard.index);
  designs_digest += digest_in_shards(database, "designs_digest", index);
  const auto remove_from = [&](const char* table) {
    RowWriter(database, fmt::format("DELETE FROM {} WHERE shard = ?", table), index).row().write();
  };
  remove_from("shards");
  for (const char* table : shard_tables) remove_from(table);
  RowWriter rows(database, "INSERT INTO shards VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?, ?, 0)", index);
  rows.row().add(whole_number(shard.count)).add(whole_number(part.total));
  rows.add(whole_number(part.generated)).add(whole_number(part.evaluated));
  rows.add(whole_number(part.without_tensions.count)).add(part.without_tensions.example);
  rows.add(whole_number(part.unconverged)).add(part.seconds);
  rows.add(static_cast<std::int64_t>(designs_digest)).write();
  write_constraints(database, index, part, description);
  write_known(database, index, part, description);
  write_designs(database, index, part);
  SQLite::Statement seal(database, "UPDATE shards SET digest = ? WHERE shard = ?");
  seal.bind(1, static_cast<std::int64_t>(digest_of_shard(database, index)));
  seal.bind(2, index);
  seal.exec();
}

void require_as_written(SQLite::Database& database, const std::filesystem::path& file) {
  for (const Shard& shard : stored_shards(database)) {
    const std::int64_t index = whole_number(shard.index);
    if (digest_in_shards(database, "digest", index) != digest_of_shard(database, index)) {
      refuse_as_changed(file, fmt::format("shard {} of {}", shard.index, shard.count),
                        "what explore saved of it");
    }
  }
  for (const char* table : shard_tables) require_shards(database, table, file);
  require_designs(database, file);
}

std::optional<ShardRecord> read_record(SQLite::Database& database, std::uint64_t shard) {
  SQLite::Statement counts =
      rows_of(database,
              "total, generated, evaluated, without_tensions, example_without_tensions, "
              "unconverged, seconds",
              "shards", "shard", shard);
  if (!counts.executeStep()) return std::nullopt;
  ShardRecord record;
  record.total = count_in(counts, 0);
  record.generated = count_in(counts, 1);
  record.evaluated = count_in(counts, 2);
  record.without_tensions = {count_in(counts, 3), counts.getColumn(4).getString()};
  record.unconverged = count_in(counts, 5);
  record.seconds = counts.getColumn(6).getDouble();
  read_counts(database, shard, record);
  read_designs(database, shard, record);
  return record;
}

std::vector<Shard> stored_shards(SQLite::Database& database) {
  std::vector<Shard> shards;
  SQLite::Statement query(database, "SELECT shard, shards FROM shards ORDER BY shard");
  while (query.executeStep()) shards.push_back({count_in(query, 0), count_in(query, 1)});
  return shards;
}

}  // namespace reeve::store
