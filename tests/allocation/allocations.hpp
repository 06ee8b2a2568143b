// Counts the calls of operator new, thread by thread: this test program replaces it. The sanitizers
// replace it themselves and must keep it to find mismatches, so under them nothing is counted.
#pragma once

#include <gtest/gtest.h>

#include <cstdint>

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
#define REEVE_UNDER_SANITIZER 1
#elif defined(__has_feature)
#if __has_feature(address_sanitizer) || __has_feature(thread_sanitizer) || \
    __has_feature(memory_sanitizer)
#define REEVE_UNDER_SANITIZER 1
#endif
#endif
#ifndef REEVE_UNDER_SANITIZER
#define REEVE_UNDER_SANITIZER 0
#endif

namespace reeve::testing {

std::uint64_t allocations();

template <typename Work>
std::uint64_t allocations_in(Work work) {
  const std::uint64_t before = allocations();
  work();
  return allocations() - before;
}

class Allocation : public ::testing::Test {
 protected:
  void SetUp() override {
    // It replaces the operators that count here; the release build runs these tests.
    if (REEVE_UNDER_SANITIZER) GTEST_SKIP() << "the sanitizer counts its own allocations";
  }
};

}  // namespace reeve::testing
