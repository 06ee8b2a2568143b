// An exploration in a store ends in the bytes of one that nothing disturbed, whatever ended its
// earlier runs; what is no store of it is refused.
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <chrono>
#include <csignal>

#include "tests/integration/stored.hpp"
#include "tests/support/has.hpp"

namespace reeve::testing {
namespace {

namespace fs = std::filesystem;
using namespace std::chrono_literals;

// A dozen batches.
const Arguments some_work("--fingers 5 --parts full --top 50");
// Hours.
const Arguments hours_of_work("--fingers 9 --parts full --top 50 --threads 2");

TEST_F(Stored, GoesOnAfterKillsToTheBytesOfTheWhole) {
  const Explored whole(some_work);
  std::vector<std::uint64_t> steps;
  for (int kills = 0; kills < 5; ++kills) {
    const std::uint64_t before = generated();
    const ProcessResult killed = explore(
        some_work, disturbed(SIGKILL, [&](const RunningProcess&) { return generated() > before; }),
        {"--threads", std::to_string(1 + kills % 2)});
    if (killed.signal != SIGKILL) break;
    EXPECT_GE(generated(), before);
    EXPECT_TRUE(!fs::exists(folder_.path() / "out/designs.csv"));
    steps.push_back(generated());
  }
  EXPECT_GE(steps.size(), 2U);
  const ProcessResult last = explore(some_work, {}, {"--threads", "3"});
  EXPECT_EQ(last.exit_code, 0) << last.err;
  expect_same_below(folder_.path() / "out", whole.out());
}

// The kernel kills it within a write to the file or its log.
TEST_F(Stored, GoesOnAfterAKillInTheMiddleOfAWrite) {
  const Explored whole(some_work);
  for (const rlim_t limit : {20000, 90000, 200000, 333333}) {
    SCOPED_TRACE(limit);
    ProcessOptions options{.file_size_limit = limit, .dies_at_file_size_limit = true};
    EXPECT_EQ(explore(some_work, options).signal, SIGXFSZ);
  }
  EXPECT_EQ(explore(some_work).exit_code, 0);
  expect_same_below(folder_.path() / "out", whole.out());
}

TEST_F(Stored, SaysThatTheDiskIsFullAndGoesOnLater) {
  const Explored whole(some_work);
  ProcessOptions options{.file_size_limit = 250000};
  const ProcessResult full = explore(some_work, options);
  EXPECT_EQ(full.exit_code, 2);
  EXPECT_TRUE(has(full.err,
                  "reeve: s.db: it cannot be written further; it holds what was stored "
                  "before ("));
  EXPECT_EQ(explore(some_work).exit_code, 0);
  expect_same_below(folder_.path() / "out", whole.out());
}

TEST_F(Stored, GoesOnAfterCtrlC) {
  const Explored whole(some_work);
  const ProcessResult stopped =
      explore(some_work, disturbed(SIGINT, [&](const RunningProcess&) { return generated() > 0; }),
              {"--threads", "1"});
  EXPECT_EQ(stopped.exit_code, 3) << stopped.err;
  const Json partial = Json::parse(read_text(folder_.path() / "out/summary.json"));
  EXPECT_TRUE(partial["partial"]);
  // Nothing that was evaluated is lost.
  EXPECT_EQ(partial["generated"], generated());
  EXPECT_EQ(explore(some_work, {}, {"--threads", "2"}).exit_code, 0);
  expect_same_below(folder_.path() / "out", whole.out());
  // Nothing is left to do, and a plain file of it.
  EXPECT_EQ(explore(some_work).exit_code, 0);
  expect_same_below(folder_.path() / "out", whole.out());
  EXPECT_FALSE(fs::exists(folder_.path() / "s.db-wal"));
}

struct KeptCase {
  const char* name;
  Arguments arguments;
};

class StoredCase : public Stored, public ::testing::WithParamInterface<KeptCase> {};

TEST_P(StoredCase, GoesOnToTheBytesOfTheWhole) {
  const Explored whole(GetParam().arguments);
  explore(GetParam().arguments,
          disturbed(SIGKILL, [&](const RunningProcess&) { return generated() > 0; }),
          {"--keep", "all"});
  EXPECT_GT(generated(), 0U);
  const ProcessResult last = explore(GetParam().arguments);
  EXPECT_EQ(last.exit_code, whole.result.exit_code) << last.err;
  expect_same_below(folder_.path() / "out", whole.out());
}

INSTANTIATE_TEST_SUITE_P(
    Of, StoredCase,
    ::testing::Values(
        KeptCase{"AShard", {"--fingers", "5", "--shard", "2/3", "--top", "20"}},
        KeptCase{"Blocks",
                 {"--fingers", "3", "--blocks", "1", "--top", "20", "--objectives",
                  "uniformity,sheaths,travel"}},
        KeptCase{"NothingMeetsThem",
                 {"--fingers", "4", "--constraint", "uniformity>=2", "--constraint", "sheaths<=1"}},
        KeptCase{"Prices",
                 {"--fingers", "4", "--cost", REEVE_CATALOG_DIR "/prices/example.toml", "--top",
                  "30", "--uncertainty", "--draws", "5"}}),
    [](const auto& tested) { return std::string(tested.param.name); });

TEST_F(Stored, RefusesOtherSettingsByNamingThem) {
  EXPECT_EQ(explore("--fingers 3").exit_code, 0);
  const std::string bytes = read_text(store());
  const std::string other = "; expected the same, or another file";
  expect_bad(explore("--fingers 3 --top 20 --constraint jams<=1"),
             "--store: s.db: it is of an exploration with other settings: constraints ([], and not "
             "[\"jams<=1\"]), top (1000, and not 20)" +
                 other);
  expect_bad(explore({"--fingers", "3", "--hardware", REEVE_CATALOG_DIR "/hardware/example.toml"}),
             "--store: s.db: it is of an exploration with other settings: hardware" + other);
  expect_bad(explore("--fingers 3 --shard 1/2"),
             "--store: s.db: it has shard 1/1; expected shards of 2, or another file");
  expect_bad(explore("--fingers 3 --keep all"),
             "--store: s.db: it keeps the best alone; expected to go on keeping these, or another "
             "file");
  EXPECT_TRUE(read_text(store()) == bytes);
}

TEST_F(Stored, RefusesAnotherVersionOfTheProgram) {
  EXPECT_EQ(explore({}).exit_code, 0);
  execute(store(),
          "UPDATE about SET value = '0.0.1' WHERE key = 'version';"
          "UPDATE about SET value = 'x' WHERE key = 'exploration'");
  const ProcessResult result = explore({});
  EXPECT_EQ(result.exit_code, 2);
  EXPECT_TRUE(has(result.err, "with another version of reeve: 0.0.1, and not "));
  const ProcessResult ranked = run("rank --store s.db");
  EXPECT_EQ(ranked.exit_code, 2);
  EXPECT_TRUE(has(ranked.err, "s.db: it was made by another version of reeve"));
}

TEST_F(Stored, RefusesAFileThatIsNotAStore) {
  const std::string start = "--store: s.db: ";
  for (const std::string text : {"rank,front,routing\n1,1,M-1-T-2-F\n", "x"}) {
    folder_.write("s.db", text);
    expect_bad(explore({}), start + "it is no SQLite database (file is not a database)");
    EXPECT_EQ(read_text(store()), text);
  }
  fs::remove(store());
  execute(store(), "CREATE TABLE cats (name TEXT)");
  const std::string cats = read_text(store());
  expect_bad(explore({}), start +
                              "it is a database, but no store of an exploration; expected what "
                              "reeve explore stored");
  EXPECT_TRUE(read_text(store()) == cats);
  fs::remove(store());
  folder_.write("s.db", "");
  expect_bad(run("rank --store s.db"),
             "s.db: explore has saved nothing in it yet; expected what it stored");
  fs::remove(store());
  fs::create_directory(store());
  expect_bad(explore({}), start + "it is a folder; expected the file of a store");
  fs::remove(store());
  EXPECT_EQ(explore({}).exit_code, 0);
  for (const std::string other : {"2", "7"}) {
    execute(store(), "PRAGMA user_version = " + other);
    expect_bad(explore({}), start + "it is a store of version " + other +
                                "; expected version 6, which this program reads");
  }
  expect_bad(run("explore --store no/s.db"),
             "--store: no/s.db: there is no folder 'no'; expected one that is there");
}

// SQLite would wait for a pipe, and say of a device that it is full.
TEST_F(Stored, RefusesAPlaceThatIsNoFile) {
  ASSERT_EQ(::mkfifo((folder_.path() / "pipe").c_str(), 0600), 0);
  const std::string expected = "it is a device or a pipe; expected the file of a store";
  for (const std::string& place : {std::string("pipe"), std::string("/dev/null")}) {
    expect_bad(run({"explore", "--store", place}), "--store: " + place + ": " + expected);
    expect_bad(run({"rank", "--store", place}), place + ": " + expected);
  }
  expect_bad(run("explore --store ''"), "--store: '': it is no name; expected that of a file");
  expect_bad(run("rank --store no.db"),
             "no.db: there is no such file; expected what reeve explore stored");
}

TEST_F(Stored, RefusesAStoreThatSomebodyChanged) {
  EXPECT_EQ(explore({}).exit_code, 0);
  execute(store(), "UPDATE shards SET total = 1");
  expect_bad(explore({}), "--store: s.db: its counts are not those of its settings");
  for (const ProcessResult& result : {run("rank --store s.db"), run("merge s.db --out m")}) {
    expect_bad(result, "s.db: shard 1 of 1: expected counts of routings that can be");
  }
  execute(store(), "UPDATE shards SET total = 126");
  execute(store(), "UPDATE archive SET routing = '1-Q' WHERE number = 0");
  const ProcessResult word = explore({});
  EXPECT_EQ(word.exit_code, 2);
  EXPECT_TRUE(has(word.err, "--store: s.db: routing '1-Q', column 3: unknown token 'Q'"));
}

// Values and words that might as well be there, rows that are gone.
TEST_F(Stored, RefusesRowsThatDifferFromWhatWasSaved) {
  EXPECT_EQ(explore("--constraint jams<=1").exit_code, 0);
  fs::copy_file(store(), folder_.path() / "whole.db");
  const std::string message =
      "s.db: shard 1 of 1: expected what explore saved of it: the file is damaged, or was changed";
  for (const char* sql :
       {"UPDATE shards SET total = 1000", "UPDATE shards SET seconds = -5",
        "UPDATE archive SET uniformity_mean = 0.5 WHERE number = 1",
        "UPDATE archive SET routing = 'M-1-F+M-2-F' WHERE number = 0",
        "DELETE FROM archive WHERE number = 3", "DELETE FROM tradeoff WHERE number = 0",
        "UPDATE sample SET place = place + 500", "UPDATE constraints SET failures = 0",
        "UPDATE known SET dominated_by = 99 WHERE number = 2"}) {
    SCOPED_TRACE(sql);
    fs::copy_file(folder_.path() / "whole.db", store(), fs::copy_options::overwrite_existing);
    execute(store(), sql);
    expect_bad(explore("--constraint jams<=1"), "--store: " + message);
    expect_bad(run("rank --store s.db"), message);
    expect_bad(run("merge s.db --out m"), message);
  }
}

TEST_F(Stored, RefusesDesignsThatAreNotAsTheyWereSaved) {
  const Arguments hand{"--hardware", REEVE_CATALOG_DIR "/hardware/three_finger_hand.toml",
                       "--fingers",  "3",
                       "--cost",     REEVE_CATALOG_DIR "/prices/example.toml"};
  for (const Arguments& arguments : {Arguments{}, hand}) {
    fs::remove(store());
    EXPECT_EQ(explore(arguments, {}, {"--keep", "all"}).exit_code, 0);
    EXPECT_EQ(run("rank --store s.db").exit_code, 0);
    for (const char* sql : {"UPDATE designs SET sheaths = 9 WHERE place = 5",
                            "DELETE FROM designs WHERE place = 1"}) {
      execute(store(), sql);
      expect_bad(run("rank --store s.db"),
                 "s.db: the table designs: expected what explore saved there: the file is damaged, "
                 "or was changed");
    }
  }
}

// What was asked is part of what was saved: here are the best alone, and none of another friction.
TEST_F(Stored, RefusesOtherSettingsThanItWasSavedWith) {
  EXPECT_EQ(explore({}).exit_code, 0);
  fs::copy_file(store(), folder_.path() / "whole.db");
  folder_.write("rough.toml", "[sheath]\nmu = 0.3\n");
  EXPECT_EQ(run("explore --hardware rough.toml --out other --store other.db").exit_code, 0);
  const std::string rows_of_another =
      "ATTACH '" + (folder_.path() / "other.db").string() + "' AS other;";
  std::string all_tables;
  for (const char* table : {"shards", "archive", "tradeoff", "known", "constraints", "sample"}) {
    const std::string name = table;
    all_tables +=
        "DELETE FROM " + name + "; INSERT INTO " + name + " SELECT * FROM other." + name + ";";
  }
  for (const std::string& sql : {std::string("UPDATE about SET value = 'all' WHERE key = 'keep'"),
                                 std::string("UPDATE settings SET value = '7' WHERE key = 'top'"),
                                 rows_of_another + all_tables}) {
    SCOPED_TRACE(sql);
    fs::copy_file(folder_.path() / "whole.db", store(), fs::copy_options::overwrite_existing);
    execute(store(), sql);
    const std::string message =
        "s.db: shard 1 of 1: expected what explore saved of it: the file is damaged, or was "
        "changed";
    expect_bad(explore({}), "--store: " + message);
    expect_bad(run("rank --store s.db --objectives sheaths"), message);
    expect_bad(run("merge s.db --out m"), message);
  }
}

// What is saved in a file that has no name any more is lost.
TEST_F(Stored, NoticesThatItIsRemovedOrReplaced) {
  const auto remove = [&] { fs::remove(store()); };
  const auto replace = [&] {
    fs::copy_file(store(), folder_.path() / "copy.db");
    fs::rename(folder_.path() / "copy.db", store());
  };
  for (const std::function<void()>& change : {std::function<void()>(remove), {replace}}) {
    const auto once_saved = [&](const RunningProcess&) {
      if (generated() == 0) return false;
      change();
      return true;
    };
    expect_bad(explore(some_work, disturbed(0, once_saved), {"--threads", "1"}),
               "s.db: somebody removed or replaced it while explore was writing it");
    fs::remove(store());
  }
}

// As a kill does within a transaction that has a journal: rows are changed, and to be changed back.
TEST_F(Stored, IsReadAfterAKillThatLeavesAJournal) {
  EXPECT_EQ(explore("--fingers 3").exit_code, 0);
  const std::string ranked = run("rank --store s.db").out;
  const std::string killed = (folder_.path() / "killed.db").string();
  const ProcessResult result = run_process(
      {"sqlite3", store().string(), "PRAGMA cache_size = 1", "BEGIN",
       "UPDATE archive SET equals_left_out = equals_left_out + 1",
       ".shell cp " + store().string() + " " + killed,
       ".shell cp " + store().string() + "-journal " + killed + "-journal", "ROLLBACK"});
  ASSERT_EQ(result.exit_code, 0) << result.err;
  ASSERT_NE(read_text(killed), read_text(store()));
  EXPECT_EQ(run("rank --store killed.db").out, ranked);
  EXPECT_FALSE(fs::exists(killed + "-journal"));
}

TEST_F(Stored, RefusesAFileThatWasCutOff) {
  EXPECT_EQ(explore(some_work).exit_code, 0);
  fs::resize_file(store(), fs::file_size(store()) / 2);
  for (const Arguments command :
       {"explore --store s.db", "rank --store s.db", "merge s.db --out m"}) {
    const ProcessResult result = run(command);
    EXPECT_EQ(result.exit_code, 2);
    EXPECT_TRUE(has(result.err, "s.db: it is damaged or cut off ("));
  }
}

// As somebody whom the permissions of files bind, which they do not root.
ProcessResult as_nobody(const Arguments& arguments, const fs::path& directory) {
  ProcessOptions options{.directory = directory};
  Arguments command;
  if (::geteuid() == 0) command = {"setpriv", "--reuid=65534", "--clear-groups"};
  command.push_back(reeve_path());
  command.insert(command.end(), arguments.begin(), arguments.end());
  return run_process(command, options);
}

TEST_F(Stored, RefusesAFileThatCannotBeWritten) {
  EXPECT_EQ(explore("--fingers 4").exit_code, 0);
  fs::permissions(store(), fs::perms(0444));
  fs::remove_all(folder_.path() / "out");
  fs::create_directory(folder_.path() / "out");
  fs::permissions(folder_.path() / "out", fs::perms(0777));
  fs::permissions(folder_.path(), fs::perms(0555));
  const auto as_usual = [&](const Arguments& arguments) {
    return as_nobody(arguments, folder_.path());
  };
  // Where the checkout lies in a folder of root's alone, nobody else can run the program; that such
  // a file is refused shows where the tests are not run as root, too.
  if (as_usual("--version").exit_code != 0) GTEST_SKIP() << "root cannot run it as somebody else";
  const ProcessResult result = as_usual("explore --fingers 4 --parts full --out out --store s.db");
  EXPECT_EQ(result.exit_code, 2);
  EXPECT_TRUE(has(result.err, "--store: s.db: it cannot be written ("));
  const ProcessResult ranked = as_usual("rank --store s.db");
  EXPECT_EQ(ranked.exit_code, 0) << ranked.err;
  fs::permissions(folder_.path(), fs::perms(0755));
}

// As whoever looks at it does when the log is set up or taken down.
TEST_F(Stored, WaitsForWhoHoldsItForAMoment) {
  explore("--fingers 2");
  const std::string held = (folder_.path() / "held").string();
  ProcessResult result;
  run_process({"sqlite3", store().string(), "PRAGMA journal_mode = WAL", "BEGIN IMMEDIATE",
               ".shell touch '" + held + "'; sleep 0.2"},
              disturbed(0, [&](const RunningProcess&) {
                if (!fs::exists(held)) return false;
                result = explore("--fingers 2");
                return true;
              }));
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_TRUE(fs::exists(held));
}

TEST_F(Stored, RefusesASecondWriterAndLetsOthersRead) {
  ProcessResult second;
  ProcessResult reader;
  explore(hours_of_work, disturbed(SIGINT, [&](const RunningProcess&) {
            if (generated() == 0) return false;
            second = explore(hours_of_work);
            reader = run("rank --store s.db --format json");
            return true;
          }));
  expect_bad(second, "--store: s.db: another process is writing it");
  EXPECT_EQ(reader.exit_code, 0) << reader.err;
  EXPECT_TRUE(Json::parse(reader.out)["partial"]);
}

}  // namespace
}  // namespace reeve::testing
