// Bad trade-offs, losses and prices: one line that names the culprit, exit code 2, nothing written.
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "tests/cli/bad_line.hpp"

namespace reeve::testing {
namespace {

const std::string needs_prices = ": expected --cost FILE.toml with it, which says what parts cost";

TEST(BadTradeoff, IsNamedWithWhatWasExpected) {
  expect_all_bad({
      {"explore --out out --tradeoff knots",
       "--tradeoff: knots not in {sheaths,blocks,pulleys,parts,cost}"},
      {"rank TR1 TR7 --tradeoff ''", "--tradeoff"},
      {"explore --out out --within 2",
       "--within '2': expected a loss in percent, from 0% to below 100%, such as 2%"},
      {"rank TR1 TR7 --within -1%", "--within '-1%': expected a loss in percent"},
      {"rank TR1 TR7 --within 100%", "--within '100%': expected a loss in percent"},
  });
}

TEST(BadCost, IsNamedWhereThereAreNoPrices) {
  expect_all_bad({
      {"explore --out out --tradeoff cost", "--tradeoff 'cost'" + needs_prices},
      {"rank TR1 TR7 --tradeoff cost", "--tradeoff 'cost'" + needs_prices},
      {"explore --out out --objectives uniformity,cost", "--objectives 'cost'" + needs_prices},
      {"rank TR1 TR7 --objectives cost", "--objectives 'cost'" + needs_prices},
      {"explore --out out --score uniformity=1,cost=0.1", "--score 'cost'" + needs_prices},
      {"explore --out out --constraint cost<=30", "--constraint 'cost<=30'" + needs_prices},
  });
}

TEST(BadPrices, AreNamedWithFileLineAndColumn) {
  expect_all_bad({
      {"explore --out out --cost ''", "--cost '': expected a TOML file"},
      {"explore --out out --cost missing.toml", "missing.toml: cannot be read: No such file"},
      {"rank TR1 TR7 --cost empty.toml",
       "empty.toml:1:1: no part has a price: expected a price above 0"},
      {"explore --out out --cost negative.toml",
       "negative.toml:1:1: tube = (a table): expected a number"},
      {"explore --out out --cost syntax.toml", "syntax.toml:1:6: not valid TOML: "},
      {"rank TR1 TR7 --cost cause.toml",
       "cause.toml:1:3: unknown key 'effect': expected one of unit, "},
  });
}

}  // namespace
}  // namespace reeve::testing
