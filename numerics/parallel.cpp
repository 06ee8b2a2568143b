#include "numerics/parallel.hpp"

#include <oneapi/tbb/global_control.h>
#include <oneapi/tbb/info.h>
#include <oneapi/tbb/task_arena.h>

#include <algorithm>
#include <atomic>
#include <exception>
#include <functional>
#include <memory>
#include <mutex>
#include <stdexcept>
#include <string_view>
#include <thread>
#include <utility>
#include <vector>

#if defined(__SANITIZE_ADDRESS__)
#include <sanitizer/lsan_interface.h>
#endif

namespace reeve::numerics {
namespace {

void throw_if_set(const std::atomic<bool>* stop) {
  if (stop != nullptr && stop->load(std::memory_order_relaxed)) throw Stopped();
}

int thread_count(int wanted) { return wanted > 0 ? wanted : tbb::info::default_concurrency(); }

using Work = std::function<void(const IndexBlock&)>;

// The blocks of one call, in their order: a thread that is free takes the next one. A thread that
// starts after the last block was taken does nothing.
class Blocks {
 public:
  Blocks(std::size_t size, std::size_t grain, const Work& work, const std::atomic<bool>* stop)
      : size_(size), grain_(grain), work_(work), stop_(stop) {}

  void work_off(std::size_t worker) noexcept {
    busy_.fetch_add(1);
    std::size_t begin = next_.fetch_add(grain_);
    try {
      for (; begin < size_; begin = next_.fetch_add(grain_)) {
        throw_if_set(stop_);
        work_({begin, std::min(begin + grain_, size_), worker});
      }
    } catch (...) {
      end_with(std::current_exception(), begin);
    }
    if (busy_.fetch_sub(1) == 1) busy_.notify_all();
  }

  // All blocks before the one that failed are begun, and will be done: that of the first is the
  // same for any number of threads.
  void end_with(std::exception_ptr failure, std::size_t begin) noexcept {
    next_.store(size_);
    const std::lock_guard lock(guard_);
    if (failure_ && failed_at_ < begin) return;
    failure_ = std::move(failure);
    failed_at_ = begin;
  }

  // Waits for busy threads, and throws the exception that ended the work.
  void finish() {
    for (int busy = busy_.load(); busy > 0; busy = busy_.load()) busy_.wait(busy);
    if (failure_) std::rethrow_exception(failure_);
  }

 private:
  std::size_t size_;
  std::size_t grain_;
  const Work& work_;  // lives until finish() returns
  const std::atomic<bool>* stop_;
  std::atomic<std::size_t> next_ = 0;
  std::atomic<int> busy_ = 0;
  std::mutex guard_;
  std::exception_ptr failure_;
  std::size_t failed_at_ = 0;
};

}  // namespace

struct Workers::Arena {
  explicit Arena(int count)
      : limit(std::make_unique<tbb::global_control>(tbb::global_control::max_allowed_parallelism,
                                                    static_cast<std::size_t>(count))),
        arena(count),
        threads(static_cast<std::size_t>(count)) {
    // The arena starts at once. If this fails for want of memory, the library waits for ever when
    // it is asked again, and when the limit is taken back.
    try {
      arena.initialize();
    } catch (...) {
      static_cast<void>(limit.release());
      throw;
    }
  }

  // More threads than cores, too, when the user asks for them.
  std::unique_ptr<tbb::global_control> limit;
  tbb::task_arena arena;
  std::size_t threads;
};

Workers::Workers(int threads, const std::atomic<bool>* stop)
    : arena_(std::make_unique<Arena>(thread_count(threads))), stop_(stop) {}
Workers::~Workers() = default;

std::size_t Workers::count() const { return arena_->threads; }

void Workers::go_on() const { throw_if_set(stop_); }

#if defined(__SANITIZE_THREAD__)

// The thread sanitizer cannot see how a library that was built without it synchronises, and reports
// races that are none. Under it the same blocks run on plain threads, so that it judges our code.
void Workers::for_each_block(std::size_t size, std::size_t grain, const Work& work) {
  Blocks blocks(size, grain, work, stop_);
  {
    std::vector<std::jthread> pool;
    for (std::size_t worker = 0; worker < count(); ++worker) {
      pool.emplace_back([&blocks, worker] { blocks.work_off(worker); });
    }
  }
  blocks.finish();
}

#else

// Tasks of the library are asked for help alone, and nobody waits for one of them: of a task that
// it cannot spawn, for want of memory, its own loops wait for ever.
void Workers::for_each_block(std::size_t size, std::size_t grain, const Work& work) {
  const auto blocks = std::make_shared<Blocks>(size, grain, work, stop_);
#if defined(__SANITIZE_ADDRESS__)
  // A helper that is still queued when the process ends holds them, in memory that the sanitizer
  // does not look through. Of a process that goes on it comes, finds nothing, and lets go.
  __lsan_ignore_object(blocks.get());
#endif
  const auto work_off = [blocks] {
    blocks->work_off(static_cast<std::size_t>(tbb::this_task_arena::current_thread_index()));
  };
  const std::size_t helpers = std::min(count(), (size + grain - 1) / grain);
  try {
    for (std::size_t i = 1; i < helpers; ++i) arena_->arena.enqueue(work_off);
  } catch (...) {
    blocks->end_with(std::current_exception(), 0);
  }
  try {
    arena_->arena.execute(work_off);
    blocks->finish();
  } catch (const std::runtime_error& error) {
    // The library has no type of its own for this.
    if (std::string_view(error.what()).starts_with("pthread_")) throw NoThreads();
    throw;
  }
}

#endif

}  // namespace reeve::numerics
