// A store that is damaged or was changed is refused, and stays byte for byte as it is.
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <csignal>
#include <filesystem>
#include <string>
#include <vector>

#include "store/schema.hpp"
#include "tests/integration/stored.hpp"
#include "tests/support/has.hpp"

namespace reeve::testing {
namespace {

namespace fs = std::filesystem;

const std::string was_changed = ": the file is damaged, or was changed";
const std::vector<Arguments> readers_of_it{{"rank", "--store", "s.db"},
                                           {"merge", "s.db", "--out", "m"}};

class DamagedStore : public Stored {
 protected:
  void SetUp() override {
    ASSERT_EQ(explore(asked_).exit_code, 0);
    whole_ = read_text(store());
  }

  void change(const std::string& sql) const {
    folder_.write("s.db", whole_);
    execute(store(), sql);
  }

  void expect_refused(const std::string& message) const {
    const std::string bytes = read_text(store());
    expect_bad(explore(asked_), "--store: s.db: " + message);
    for (const Arguments& reader : readers_of_it) expect_bad(run(reader), "s.db: " + message);
    EXPECT_TRUE(read_text(store()) == bytes);
  }

  Arguments asked_ = "--constraint jams<=1";
  std::string whole_;
};

// The record of each shard says nothing of them, and yet they would be listed.
TEST_F(DamagedStore, WithRowsOfAShardThatHasNotBegun) {
  for (const char* table : {"constraints", "known", "archive", "tradeoff", "sample"}) {
    SCOPED_TRACE(table);
    const std::string name = table;
    const std::string key = name == "sample" ? "place" : "number";
    const std::string only = name == "constraints" ? "0" : "1";
    change("CREATE TEMP TABLE one AS SELECT * FROM " + name + " WHERE " + key + " >= " + only +
           " LIMIT 1; UPDATE one SET shard = 7, " + key + " = 1; INSERT INTO " + name +
           " SELECT * FROM one");
    expect_refused("the table " + name + ", row shard = 7, " + key +
                   " = 1: expected a shard of the table shards" + was_changed);
  }
}

TEST_F(DamagedStore, WithDesignsThatItDoesNotKeep) {
  change("INSERT INTO designs SELECT 0, routing" + objective_columns() + " FROM archive LIMIT 1");
  expect_refused("the table designs: expected what explore saved there" + was_changed);
}

// It would act while the store is written, before the digest is taken.
TEST_F(DamagedStore, WithATrigger) {
  change("CREATE TRIGGER t AFTER INSERT ON sample BEGIN DELETE FROM archive; END");
  expect_refused(
      "its tables are not those of a store: it is damaged, or was changed; expected "
      "what reeve explore stored");
}

// SQLite would wait for somebody to write to it.
TEST_F(DamagedStore, BesideAPipeThatIsTakenForALog) {
  ASSERT_EQ(::mkfifo((store().string() + "-journal").c_str(), 0600), 0);
  expect_refused("'s.db-journal' beside it is no file; expected a file of SQLite's, or none");
}

TEST_F(DamagedStore, WithAShardThatWasNotExplored) {
  change(
      "INSERT INTO shards SELECT 2, shards, total, generated, evaluated, "
      "without_tensions, example_without_tensions, unconverged, seconds, designs_digest, digest FROM shards");
  expect_refused("shard 2 of 1: expected what explore saved of it" + was_changed);
}

// Every byte of the header and some of every page, changed in its last bit or in all of them by
// turns. Who only reads opens the file so, and is asked now and then.
TEST_F(DamagedStore, StaysAsItIsWhereItIsRefused) {
  std::vector<std::size_t> places;
  for (std::size_t place = 0; place < 100; ++place) places.push_back(place);
  for (std::size_t place = 100; place < whole_.size(); place += 8111) places.push_back(place);
  int refused = 0;
  for (std::size_t i = 0; i < places.size(); ++i) {
    const std::size_t place = places[i];
    const unsigned mask = i % 2 == 0 ? 1U : 0xffU;
    SCOPED_TRACE(std::to_string(place) + " ^ " + std::to_string(mask));
    std::string damaged = whole_;
    damaged[place] = static_cast<char>(static_cast<unsigned char>(damaged[place]) ^ mask);
    folder_.write("s.db", damaged);
    std::vector<ProcessResult> results;
    if (i % 11 == 0) results = {run(readers_of_it[0]), run(readers_of_it[1])};
    results.push_back(explore(asked_));
    for (const ProcessResult& result : results) {
      if (result.exit_code == 0) continue;
      EXPECT_EQ(result.exit_code, 2) << result.err;
      EXPECT_TRUE(read_text(store()) == damaged) << result.err;
      ++refused;
    }
    for (const char* left : {"s.db-wal", "s.db-shm"}) fs::remove(folder_.path() / left);
  }
  EXPECT_GT(refused, 60);
}

TEST_F(DamagedStore, WithAColumnOfAnotherName) {
  std::string damaged = whole_;
  const std::size_t place = damaged.find("equals_left_out INTEGER");
  ASSERT_NE(place, std::string::npos);
  damaged[place] = 'f';
  folder_.write("s.db", damaged);
  expect_refused(
      "its tables are not those of a store: it is damaged, or was changed; expected what reeve "
      "explore stored");
}

// A free page is read by nobody but who writes next.
TEST_F(DamagedStore, IsNotWrittenWhereItsFreePagesAreNotFree) {
  change("CREATE TABLE t (x); INSERT INTO t VALUES (zeroblob(20000)); DROP TABLE t");
  std::string damaged = read_text(store());
  damaged[35] = 3;  // the first page of the list of free pages
  folder_.write("s.db", damaged);
  const ProcessResult result = explore(asked_);
  EXPECT_EQ(result.exit_code, 2);
  EXPECT_TRUE(has(result.err, "--store: s.db: it is damaged or cut off ("));
  EXPECT_TRUE(read_text(store()) == damaged);
}

// The log of a run that was killed holds its last save.
TEST_F(DamagedStore, KeepsItsLogWhereItIsRefused) {
  fs::remove(store());
  const Arguments work("--fingers 5 --parts full");
  explore(work, disturbed(SIGKILL, [&](const RunningProcess&) { return generated() > 0; }));
  const std::string bytes = read_text(store());
  const std::string log = read_text(folder_.path() / "s.db-wal");
  EXPECT_FALSE(log.empty());
  EXPECT_EQ(explore(asked_).exit_code, 2);
  EXPECT_TRUE(read_text(store()) == bytes);
  EXPECT_TRUE(read_text(folder_.path() / "s.db-wal") == log);
}

}  // namespace
}  // namespace reeve::testing
