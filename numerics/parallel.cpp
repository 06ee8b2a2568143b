#include "numerics/parallel.hpp"

#include <oneapi/tbb/blocked_range.h>
#include <oneapi/tbb/global_control.h>
#include <oneapi/tbb/info.h>
#include <oneapi/tbb/parallel_for.h>
#include <oneapi/tbb/task_arena.h>

namespace reeve {
namespace {

int thread_count(int wanted) { return wanted > 0 ? wanted : tbb::info::default_concurrency(); }

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

Workers::Workers(int threads) : arena_(std::make_unique<Arena>(thread_count(threads))) {}
Workers::~Workers() = default;

std::size_t Workers::count() const { return arena_->threads; }

void Workers::for_each_block(std::size_t size, std::size_t grain,
                             const std::function<void(const IndexBlock&)>& work) {
  arena_->arena.execute([&] {
    tbb::parallel_for(
        tbb::blocked_range<std::size_t>(0, size, grain),
        [&](const tbb::blocked_range<std::size_t>& range) {
          const auto worker = static_cast<std::size_t>(tbb::this_task_arena::current_thread_index());
          work({range.begin(), range.end(), worker});
        },
        tbb::simple_partitioner());
  });
}

}  // namespace reeve
