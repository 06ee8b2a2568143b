#include <gtest/gtest.h>

#include "cli/inputs.hpp"
#include "core/notation.hpp"
#include "search/enumerate/parts.hpp"
#include "search/explore.hpp"
#include "tests/support/input_error.hpp"

namespace reeve::cli {
namespace {

using testing::input_fault;

TEST(OptionFault, NamesTheOptionAsItIsWrittenOnTheCommandLine) {
  EXPECT_EQ(input_fault([] { for_name("--", [] { return parse_shard("9/8"); }); }),
            "- | --shard | 9/8 | i/N with 1 <= i <= N, such as 2/8");
  EXPECT_EQ(input_fault([] { for_name("--", [] { return parse_joins("T,Q"); }); }),
            "--joins 'T,Q' |  | Q | a comma-separated list of T, B, P");
}

TEST(OptionFault, NamesTheOptionAsThePlaceOfAnErrorInItsFile) {
  EXPECT_EQ(
      input_fault([] { for_option("--routings", [] { return parse_routing("Q"); }); }),
      "--routings: routing 'Q', column 1 | unknown token | Q | M, F, T, B, P, a finger such as 1, 2b or 3x, a block such as Y1 or Y1k, or a bar such as W1");
}

}  // namespace
}  // namespace reeve::cli
