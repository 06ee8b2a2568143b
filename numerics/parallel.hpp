// An indexed parallel loop. Each index is visited once and writes only its own slot of the caller's
// arrays, so that the result is the same for any number of threads.
#pragma once

#include <atomic>
#include <cstddef>
#include <exception>
#include <functional>
#include <memory>
#include <new>

#include "numerics/floors.hpp"

namespace reeve::numerics {

// Half-open block of indices, worked on by one worker (0 … threads - 1) at a time.
struct IndexBlock {
  std::size_t begin = 0;
  std::size_t end = 0;
  std::size_t worker = 0;
};

// No thread can be had: there is no memory for its stack, or a limit on threads is reached.
class NoThreads : public std::bad_alloc {
 public:
  const char* what() const noexcept override {
    return "no more threads: not enough memory, or too many threads";
  }
};

// The result is no longer needed.
class Stopped : public std::exception {
 public:
  const char* what() const noexcept override { return "stopped"; }
};

class Workers {
 public:
  // 0: as many threads as the machine has. `stop`, which any thread may set, ends the work.
  explicit Workers(int threads, const std::atomic<bool>* stop = nullptr);
  ~Workers();
  Workers(const Workers&) = delete;
  Workers& operator=(const Workers&) = delete;

  std::size_t count() const;

  // Cuts 0 … size into blocks of at most `grain` indices and begins them in their order; the
  // exception of the first that fails comes through. Throws NoThreads, and Stopped before the next
  // block once `stop` is set.
  void for_each_block(std::size_t size, std::size_t grain,
                      const std::function<void(const IndexBlock&)>& work);

  // Throws Stopped once `stop` is set: for long work between loops.
  void go_on() const;

 private:
  struct Arena;
  std::unique_ptr<Arena> arena_;
  const std::atomic<bool>* stop_;
};

}  // namespace reeve::numerics
