#include "numerics/parallel.hpp"

#include <oneapi/tbb/blocked_range.h>
#include <oneapi/tbb/global_control.h>
#include <oneapi/tbb/info.h>
#include <oneapi/tbb/parallel_for.h>
#include <oneapi/tbb/task_arena.h>

#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>
#include <stdexcept>
#include <string_view>
#include <thread>
#include <vector>

namespace reeve::numerics {
namespace {

int thread_count(int wanted) { return wanted > 0 ? wanted : tbb::info::default_concurrency(); }

#if defined(__SANITIZE_THREAD__)

// The thread sanitizer cannot see how a library that was built without it synchronises, and reports
// races that are none. Under it the same blocks run on plain threads, so that it judges our code.
void run_on_plain_threads(std::size_t threads, std::size_t size, std::size_t grain,
                          const std::function<void(const IndexBlock&)>& work) {
  std::atomic<std::size_t> next{0};
  std::mutex guard;
  std::exception_ptr failure;
  {
    std::vector<std::jthread> pool;
    for (std::size_t worker = 0; worker < threads; ++worker) {
      pool.emplace_back([&, worker] {
        try {
          for (std::size_t begin = next.fetch_add(grain); begin < size;
               begin = next.fetch_add(grain)) {
            work({begin, std::min(begin + grain, size), worker});
          }
        } catch (...) {
          const std::lock_guard lock(guard);
          failure = std::current_exception();
        }
      });
    }
  }
  if (failure) std::rethrow_exception(failure);
}

#endif

}  // namespace

struct Workers::Arena {
  explicit Arena(int count)
      : limit(tbb::global_control::max_allowed_parallelism, static_cast<std::size_t>(count)),
        arena(count),
        threads(static_cast<std::size_t>(count)) {}

  tbb::global_control limit;  // more threads than cores, too, when the user asks for them
  tbb::task_arena arena;
  std::size_t threads;
};

Workers::Workers(int threads, const std::atomic<bool>* stop)
    : arena_(std::make_unique<Arena>(thread_count(threads))), stop_(stop) {}
Workers::~Workers() = default;

std::size_t Workers::count() const { return arena_->threads; }

void Workers::go_on() const {
  if (stop_ != nullptr && stop_->load(std::memory_order_relaxed)) throw Stopped();
}

void Workers::for_each_block(std::size_t size, std::size_t grain,
                             const std::function<void(const IndexBlock&)>& work) {
#if defined(__SANITIZE_THREAD__)
  run_on_plain_threads(arena_->threads, size, grain, [&](const IndexBlock& block) {
    go_on();
    work(block);
  });
#else
  try {
    arena_->arena.execute([&] {
      tbb::parallel_for(
          tbb::blocked_range<std::size_t>(0, size, grain),
          [&](const tbb::blocked_range<std::size_t>& range) {
            go_on();
            const auto worker =
                static_cast<std::size_t>(tbb::this_task_arena::current_thread_index());
            work({range.begin(), range.end(), worker});
          },
          tbb::simple_partitioner());
    });
  } catch (const std::runtime_error& error) {
    // The library has no type of its own for this.
    if (std::string_view(error.what()).starts_with("pthread_")) throw NoThreads();
    throw;
  }
#endif
}

}  // namespace reeve::numerics
