// One run of `reeve rank --out`, and the page, figures and file that it writes.
#pragma once

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "reports/output/json.hpp"
#include "tests/support/process.hpp"
#include "tests/support/read_chart.hpp"
#include "tests/support/temporary_folder.hpp"

namespace reeve::testing {

struct Ranked {
  explicit Ranked(std::vector<std::string> arguments) {
    arguments.insert(arguments.begin(), "rank");
    arguments.insert(arguments.end(), {"--out", (folder.path() / "page").string()});
    result = reeve(arguments);
    EXPECT_EQ(result.exit_code, 0) << result.err;
    html = read_text(folder.path() / "page" / "index.html");
    json = Json::parse(read_text(folder.path() / "page" / "ranking.json"));
  }

  // The panels of a figure's file.
  std::vector<ReadPanel> chart(const std::string& figure) const {
    return read_chart(read_text(folder.path() / "page" / "figures" / (figure + ".svg")));
  }

  TemporaryFolder folder;
  ProcessResult result;
  std::string html;
  Json json;
};

inline const Ranked& catalogue() {
  static const Ranked ranked({"--catalogue"});
  return ranked;
}

}  // namespace reeve::testing
