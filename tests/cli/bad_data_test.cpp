// Data files that `compare` refuses; tests/diagnosis has the details of each message.
#include <gtest/gtest.h>

#include <string>

#include "tests/cli/bad_line.hpp"

namespace reeve::testing {
namespace {

TEST(BadData, AreNamedWithFileLineAndColumn) {
  const auto compare = [](Arguments arguments, const std::string& message) {
    arguments.insert(arguments.begin(), {"compare", "--out", "out"});
    return BadLine{arguments, message, {}};
  };
  expect_all_bad({
      {{"compare"}, "data is required", {}},
      compare({"none.csv"}, "none.csv: cannot be read: No such file or directory"),
      compare({"no_catalogue"}, "no_catalogue: is a directory: expected a CSV file"),
      compare({"cell.csv"}, "cell.csv:2: column 'T1_N' = 'x': expected a number from 0 to "),
      compare({"name.csv"},
              "name.csv:2: column 'routing' = 'TR9': routing 'TR9': no such name in the catalogue"),
      compare({"ragged.csv"}, "ragged.csv:2:6: the row ends after 2 fields: expected 3"),
      compare({"alone.csv"}, "alone.csv: there is nothing to compare: expected rows with "),
      compare({"ok.csv", "--hardware", "contact.toml"}, "hardware: contact 'a-T9': expected two"),
      compare({"ok.csv", "--format", "csv"}, "--format: csv not in {table,json}"),
      {{"compare", "ok.csv", "--out", "cell.csv"},
       "--out 'cell.csv': expected a folder that can be written to: Not a directory",
       {}},
      {{"compare", "residuals.csv", "--out", "."},
       "--out '.': './residuals.csv' would be written over the data: expected another folder",
       {}},
  });
}

}  // namespace
}  // namespace reeve::testing
