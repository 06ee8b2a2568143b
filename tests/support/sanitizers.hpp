// Tells whether what is tested is instrumented. Under AddressSanitizer most tests are not: that
// would take as long as all that they test. A sanitizer's runtime has to be loaded before
// everything else, has an allocator of its own, and takes several times as long. Rates and sizes,
// which do not hang on it, are told by the release build.
#pragma once

#include <gtest/gtest.h>

namespace reeve::testing {

bool has_sanitizer();

}  // namespace reeve::testing

#define SKIP_UNDER_SANITIZERS()                   \
  if (::reeve::testing::has_sanitizer()) {        \
    GTEST_SKIP() << "the release build tells it"; \
  }                                               \
  static_assert(true)
