#include "store/exploration_store.hpp"

#include <fmt/format.h>

#include <utility>

#include "core/error.hpp"
#include "core/notation.hpp"
#include "store/database.hpp"
#include "store/digest.hpp"
#include "store/record_rows.hpp"
#include "store/schema.hpp"

namespace reeve::store {
namespace {

// The log lets others read while this one writes, and survives a power cut.
constexpr const char* durable_writing =
    "PRAGMA journal_mode = WAL; PRAGMA synchronous = FULL; PRAGMA journal_size_limit = 16777216";

// An error in a word names this file.
void require_routings(const ShardRecord& record, const std::filesystem::path& file) {
  try {
    for (const ArchivedWord& kept : record.archive) parse_routing(kept.word);
    for (const std::string& step : record.steps) parse_routing(step);
    for (const SampledWord& sampled : record.sample) parse_routing(sampled.word);
  } catch (const InputError& error) {
    throw error.at(file.string());
  }
}

void require_same(SQLite::Database& database, const Description& asked, const Shard& shard,
                  const std::filesystem::path& file) {
  if (const auto differs = difference(read_description(database), asked)) {
    throw InputError({.where = file.string(),
                      .what = fmt::format("it is of an exploration with {}", *differs),
                      .expected = "the same, or another file",
                      .form = InputForm::unknown});
  }
  for (const Shard& there : stored_shards(database)) {
    if (there.count == shard.count) continue;
    throw InputError({.where = file.string(),
                      .what = fmt::format("it has shard {}/{}", there.index, there.count),
                      .expected = fmt::format("shards of {}, or another file", shard.count),
                      .form = InputForm::unknown});
  }
}

}  // namespace

// Writes until the end. A reader that begins or ends may delay it for a moment.
struct ExplorationStore::Connection {
  Connection(const std::filesystem::path& file, std::unique_ptr<WriterLock> taken)
      : lock(std::move(taken)), database(open_to_write(file)) {
    database.exec(durable_writing);
    database.exec("BEGIN IMMEDIATE");
  }
  Connection(const Connection&) = delete;
  Connection& operator=(const Connection&) = delete;
  // Drops unsaved data and leaves one plain file, which can be read without write access. If that
  // fails, the next process to open it finds the log.
  ~Connection() {
    insert.reset();
    database.tryExec("ROLLBACK");
    database.tryExec("PRAGMA journal_mode = DELETE");
  }

  void commit() {
    database.exec("COMMIT");
    database.exec("BEGIN IMMEDIATE");
  }

  std::unique_ptr<WriterLock> lock;
  SQLite::Database database;
  std::optional<SQLite::Statement> insert;
};

ExplorationStore::ExplorationStore(std::filesystem::path file, Description asked, Shard shard,
                                   std::optional<Keep> keep)
    : file_(std::move(file)), asked_(std::move(asked)), shard_(shard) {
  in_database(file_, [&] {
    auto lock = std::make_unique<WriterLock>(file_);
    const bool is_there = is_there_and_same(keep);
    connection_ = std::make_unique<Connection>(file_, std::move(lock));
    if (is_there) return;
    keep_ = keep.value_or(Keep::best);
    create_tables(connection_->database);
    write_about(connection_->database, asked_, keep_);
    connection_->commit();
  });
}

ExplorationStore::~ExplorationStore() = default;

// Only reads: a file that is refused stays byte for byte as it is, and even a log that is set up
// and taken down again changes its header.
bool ExplorationStore::is_there_and_same(std::optional<Keep> keep) {
  std::optional<SQLite::Database> database = open_store(file_, Access::write);
  if (!database) return false;
  // The transaction makes all reads see one state.
  database->exec("BEGIN");
  require_same(*database, asked_, shard_, file_);
  keep_ = read_keep(*database);
  if (keep) require_keep(*keep);
  require_record(read_record(*database, shard_.index));
  require_as_written(*database, file_);
  require_sound(*database);
  return true;
}

void ExplorationStore::require_keep(Keep asked) const {
  if (asked == keep_) return;
  throw InputError({.where = file_.string(),
                    .what = keep_ == Keep::all ? "it keeps all designs" : "it keeps the best alone",
                    .expected = "to go on keeping these, or another file",
                    .form = InputForm::unknown});
}

void ExplorationStore::require_record(const std::optional<ShardRecord>& record) const {
  if (!record) return;
  require_routings(*record, file_);
  const bool fits = record->references.size() == asked_.known.size() &&
                    record->constraint_failures.size() == asked_.limits.size() &&
                    record->generated <= record->total;
  if (fits) return;
  throw InputError({.where = file_.string(),
                    .what = "its counts are not those of its settings",
                    .form = InputForm::unknown});
}

std::optional<ShardRecord> ExplorationStore::record() const {
  return in_database(file_, [&] { return read_record(connection_->database, shard_.index); });
}

void ExplorationStore::add(const EvaluatedDesign& design) {
  in_database(file_, [&] {
    std::optional<SQLite::Statement>& insert = connection_->insert;
    if (!insert) {
      insert.emplace(connection_->database,
                     fmt::format("INSERT INTO designs VALUES (?, ?{})", objective_marks()));
    }
    insert->reset();
    insert->bind(1, whole_number(design.place));
    insert->bind(2, design.word);
    bind_objectives(*insert, 3, design.values);
    insert->exec();
  });
  ++added_since_save_;
  added_digest_ += digest_of(design);
}

void ExplorationStore::save(ExplorationPart& so_far) {
  in_database(file_, [&] {
    // It would hold a commit up.
    connection_->insert.reset();
    write_record(connection_->database, shard_, so_far, asked_, added_digest_);
    connection_->commit();
  });
  require_there();
  added_since_save_ = 0;
  added_digest_ = 0;
}

// Throws if the file has lost its name: data saved in it would be lost at the end.
void ExplorationStore::require_there() const {
  if (connection_->lock->is_on(file_)) return;
  throw InputError({.where = file_.string(),
                    .what = "somebody removed or replaced it while explore was writing it"});
}

}  // namespace reeve::store
