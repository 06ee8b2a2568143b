#include "numerics/parallel.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#include "core/error.hpp"
#include "numerics/random.hpp"

#if defined(__SANITIZE_ADDRESS__)
#include <sanitizer/lsan_interface.h>
#endif

namespace reeve {
namespace {

constexpr int thread_counts[] = {1, 2, 3, 8};

void expect_every_index_once(Workers& workers, std::size_t size, std::size_t grain) {
  std::vector<std::atomic<int>> visits(size);
  std::atomic<bool> blocks_are_good = true;
  workers.for_each_block(size, grain, [&](const IndexBlock& block) {
    const bool good = block.begin < block.end && block.end <= size &&
                      block.end - block.begin <= grain && block.worker < workers.count();
    if (!good) blocks_are_good = false;
    for (std::size_t i = block.begin; i < block.end && i < size; ++i) ++visits[i];
  });
  EXPECT_TRUE(blocks_are_good);
  for (std::size_t i = 0; i < size; ++i) ASSERT_EQ(visits[i], 1) << "index " << i;
}

TEST(Parallel, EveryIndexIsVisitedOnceInBlocksOfAtMostTheGrain) {
  for (const int threads : thread_counts) {
    Workers workers(threads);
    for (const std::size_t size : {0, 1, 2, 7, 64, 1000}) {
      for (const std::size_t grain : {1, 2, 3, 16, 64, 999, 100000}) {
        SCOPED_TRACE(std::to_string(threads) + " threads, size " + std::to_string(size) +
                     ", grain " + std::to_string(grain));
        expect_every_index_once(workers, size, grain);
      }
    }
  }
}

// Each of two blocks waits for the other.
TEST(Parallel, TwoBlocksAreWorkedOnAtOnce) {
  std::atomic<int> begun = 0;
  std::atomic<bool> met = true;
  const auto deadline = std::chrono::steady_clock::now() + std::chrono::seconds(10);
  Workers(2).for_each_block(2, 1, [&](const IndexBlock&) {
    ++begun;
    while (begun < 2 && std::chrono::steady_clock::now() < deadline) std::this_thread::yield();
    if (begun < 2) met = false;
  });
  EXPECT_TRUE(met);
}

TEST(Parallel, NothingIsCalledForNoIndex) {
  Workers workers(2);
  std::atomic<int> calls = 0;
  workers.for_each_block(0, 1, [&](const IndexBlock&) { ++calls; });
  EXPECT_EQ(calls, 0);
}

TEST(Parallel, StopsBeforeTheNextBlockOnceItIsAskedTo) {
  for (const int threads : thread_counts) {
    std::atomic<bool> stop = false;
    Workers workers(threads, &stop);
    workers.go_on();
    std::atomic<int> blocks = 0;
    const auto work = [&](const IndexBlock&) {
      if (++blocks == 5) stop = true;
    };
    EXPECT_THROW(workers.for_each_block(100000, 1, work), Stopped);
    EXPECT_LT(blocks, 5 + 2 * threads);
    EXPECT_THROW(workers.for_each_block(1, 1, work), Stopped);
    EXPECT_THROW(workers.go_on(), Stopped);
  }
}

TEST(Parallel, CountIsTheNumberOfThreadsAskedFor) {
  for (const int threads : thread_counts) {
    EXPECT_EQ(Workers(threads).count(), static_cast<std::size_t>(threads));
  }
  EXPECT_GE(Workers(0).count(), 1U);
}

// Scratch memory by worker needs no lock.
TEST(Parallel, AWorkerHasOneBlockAtATime) {
  for (const int threads : thread_counts) {
    Workers workers(threads);
    std::vector<std::atomic<int>> busy(workers.count());
    std::atomic<bool> alone = true;
    std::vector<std::uint64_t> sums(workers.count(), 0);
    workers.for_each_block(20000, 1, [&](const IndexBlock& block) {
      if (busy[block.worker]++ != 0) alone = false;
      sums[block.worker] += block.begin;
      --busy[block.worker];
    });
    EXPECT_TRUE(alone);
    std::uint64_t sum = 0;
    for (const std::uint64_t part : sums) sum += part;
    EXPECT_EQ(sum, 20000U * 19999U / 2);
  }
}

TEST(Parallel, TheResultIsTheSameForAnyNumberOfThreadsAndAnyGrain) {
  const auto results = [](int threads, std::size_t grain) {
    std::vector<double> slots(5000);
    Workers(threads).for_each_block(slots.size(), grain, [&](const IndexBlock& block) {
      for (std::size_t i = block.begin; i < block.end; ++i) slots[i] = uniform(1, 2, i);
    });
    return slots;
  };
  const std::vector<double> expected = results(1, 5000);
  for (const int threads : thread_counts) {
    for (const std::size_t grain : {1, 7, 512}) EXPECT_EQ(results(threads, grain), expected);
  }
}

TEST(Parallel, ExceptionsComeThroughWithTypeAndMessage) {
  for (const int threads : thread_counts) {
    Workers workers(threads);
    try {
      workers.for_each_block(1000, 1, [](const IndexBlock& block) {
        if (block.begin == 500) throw InputError("at 500");
      });
      ADD_FAILURE() << "no exception with " << threads << " threads";
    } catch (const InputError& error) {
      EXPECT_STREQ(error.what(), "at 500");
    }
    expect_every_index_once(workers, 100, 3);
  }
}

TEST(Parallel, OneOfManyExceptionsComesThrough) {
  Workers workers(3);
  EXPECT_THROW(workers.for_each_block(
                   100, 1, [](const IndexBlock&) { throw std::runtime_error("each block"); }),
               std::runtime_error);
}

TEST(Parallel, TheExceptionOfTheFirstBlockComesThrough) {
  for (const int threads : thread_counts) {
    Workers workers(threads);
    for (int round = 0; round < 20; ++round) {
      try {
        workers.for_each_block(40, 1, [&](const IndexBlock& block) {
          if (block.begin < 3) return;
          // The first that fails takes the longest to, or the shortest.
          const bool is_slow = (block.begin == 3) == (round % 2 == 0);
          std::this_thread::sleep_for(std::chrono::microseconds(is_slow ? 500 : 10));
          throw std::runtime_error(std::to_string(block.begin));
        });
        ADD_FAILURE() << "no exception with " << threads << " threads";
      } catch (const std::runtime_error& error) {
        EXPECT_STREQ(error.what(), "3");
      }
    }
  }
}

#if defined(__SANITIZE_ADDRESS__)

// Nearly all helpers of so short a call are still queued at its end.
TEST(Parallel, LateHelpersDoNotLeak) {
  for (int round = 0; round < 50; ++round) {
    Workers(2).for_each_block(2, 1, [](const IndexBlock&) {});
  }
  EXPECT_EQ(__lsan_do_recoverable_leak_check(), 0);
}

#endif

}  // namespace
}  // namespace reeve
