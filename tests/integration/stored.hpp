// Explorations that are kept in a store, and what their tests share.
#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <string>

#include "store/store_reader.hpp"
#include "tests/integration/explored.hpp"

namespace reeve::testing {

inline void expect_same_below(const std::filesystem::path& actual,
                              const std::filesystem::path& expected) {
  const auto a = files_below(actual);
  const auto e = files_below(expected);
  EXPECT_EQ(a.size(), e.size());
  for (const auto& [name, text] : e) {
    ASSERT_TRUE(a.contains(name)) << name;
    EXPECT_TRUE(a.at(name) == text) << name << "\n" << a.at(name).substr(0, 2000);
  }
}

inline void execute(const std::filesystem::path& file, const std::string& sql) {
  const ProcessResult result = run_process({"sqlite3", file.string(), sql});
  EXPECT_EQ(result.exit_code, 0) << result.err;
}

class Stored : public ::testing::Test {
 protected:
  std::filesystem::path store() const { return folder_.path() / "s.db"; }

  ProcessResult run(Arguments arguments, ProcessOptions options = {}) const {
    options.directory = folder_.path();
    return reeve(arguments, options);
  }

  // Into the store, which is written after every batch.
  ProcessResult explore(const Arguments& arguments, ProcessOptions options = {},
                        const Arguments& besides = {}) const {
    Arguments command("explore --out out --store s.db --store-every 0");
    command.insert(command.end(), arguments.begin(), arguments.end());
    command.insert(command.end(), besides.begin(), besides.end());
    return run(with_full_parts(command), std::move(options));
  }

  // Of its first shard; 0 if nothing has been saved.
  std::uint64_t generated() const {
    try {
      const std::vector<StoredShard> shards = StoreReader(store()).shards();
      return shards.empty() ? 0 : shards.front().record.generated;
    } catch (const InputError&) {
      return 0;  // just being made
    }
  }

  void expect_bad(const ProcessResult& result, const std::string& message) const {
    EXPECT_EQ(result.exit_code, 2);
    EXPECT_EQ(result.err, "reeve: " + message + "\n");
    EXPECT_EQ(result.out, "");
  }

  TemporaryFolder folder_;
};

}  // namespace reeve::testing
