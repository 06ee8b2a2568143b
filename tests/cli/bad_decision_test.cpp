// Bad ladders, losses and prices: one line that names the culprit, exit code 2, nothing written.
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "tests/cli/bad_line.hpp"

namespace reeve::testing {
namespace {

BadLine exploring(Arguments options, const std::string& message) {
  options.insert(options.begin(), {"explore", "--out", "out"});
  return {options, message, {}};
}

BadLine ranking(Arguments options, const std::string& message) {
  options.insert(options.begin(), {"rank", "TR1", "TR7"});
  return {options, message, {}};
}

const std::string needs_prices = ": expected --cost FILE.toml with it, which says what parts cost";

TEST(BadLadder, IsNamedWithWhatWasExpected) {
  expect_all_bad({
      exploring({"--ladder", "knots"},
                "--ladder: knots not in {sheaths,blocks,pulleys,parts,cost}"),
      ranking({"--ladder", ""}, "--ladder"),
      exploring({"--within", "2"},
                "--within '2': expected a loss in percent, from 0% to below 100%, such as 2%"),
      ranking({"--within", "-1%"}, "--within '-1%': expected a loss in percent"),
      ranking({"--within", "100%"}, "--within '100%': expected a loss in percent"),
  });
}

TEST(BadCost, IsNamedWhereThereAreNoPrices) {
  expect_all_bad({
      exploring({"--ladder", "cost"}, "--ladder 'cost'" + needs_prices),
      ranking({"--ladder", "cost"}, "--ladder 'cost'" + needs_prices),
      exploring({"--objectives", "uniformity,cost"}, "--objectives 'cost'" + needs_prices),
      ranking({"--objectives", "cost"}, "--objectives 'cost'" + needs_prices),
      exploring({"--score", "uniformity=1,cost=0.1"}, "--score 'cost'" + needs_prices),
      exploring({"--constraint", "cost<=30"}, "--constraint 'cost<=30'" + needs_prices),
  });
}

TEST(BadPrices, AreNamedWithFileLineAndColumn) {
  expect_all_bad({
      exploring({"--cost", ""}, "--cost '': expected a TOML file"),
      exploring({"--cost", "missing.toml"}, "missing.toml: cannot be read: No such file"),
      ranking({"--cost", "empty.toml"},
              "empty.toml:1:1: no part has a price: expected a price above 0"),
      exploring({"--cost", "negative.toml"},
                "negative.toml:1:1: tube = (a table): expected a number"),
      exploring({"--cost", "syntax.toml"}, "syntax.toml:1:6: not valid TOML: "),
      ranking({"--cost", "cause.toml"},
              "cause.toml:1:3: unknown key 'effect': expected one of unit, "),
  });
}

}  // namespace
}  // namespace reeve::testing
