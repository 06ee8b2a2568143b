// Evaluating routing after routing allocates nothing: memory that is asked for in the inner loop of
// an exploration would cost more than the tensions.
//
// Counted by replacing operator new for the whole test program, thread by thread. The sanitizers
// replace it themselves and must keep it to find mismatches, so there nothing is counted.
#include <gtest/gtest.h>

#include <cstdint>
#include <cstdlib>
#include <new>
#include <string>
#include <vector>

#include "search/evaluation.hpp"
#include "search/generator.hpp"

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

namespace {
thread_local std::uint64_t allocations = 0;
}  // namespace

#if !REEVE_UNDER_SANITIZER
namespace {

void* counted(std::size_t size) noexcept {
  ++allocations;
  return std::malloc(size == 0 ? 1 : size);
}

void* counted(std::size_t size, std::align_val_t alignment) noexcept {
  ++allocations;
  const auto unit = static_cast<std::size_t>(alignment);
  return std::aligned_alloc(unit, (size + unit) / unit * unit);  // never 0
}

void* or_throw(void* memory) {
  if (memory == nullptr) throw std::bad_alloc();
  return memory;
}

}  // namespace

void* operator new(std::size_t size) { return or_throw(counted(size)); }
void* operator new[](std::size_t size) { return or_throw(counted(size)); }
void* operator new(std::size_t size, const std::nothrow_t&) noexcept { return counted(size); }
void* operator new[](std::size_t size, const std::nothrow_t&) noexcept { return counted(size); }
void* operator new(std::size_t size, std::align_val_t a) { return or_throw(counted(size, a)); }
void* operator new[](std::size_t size, std::align_val_t a) { return or_throw(counted(size, a)); }
void* operator new(std::size_t size, std::align_val_t a, const std::nothrow_t&) noexcept {
  return counted(size, a);
}
void* operator new[](std::size_t size, std::align_val_t a, const std::nothrow_t&) noexcept {
  return counted(size, a);
}
void operator delete(void* memory) noexcept { std::free(memory); }
void operator delete[](void* memory) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }
void operator delete[](void* memory, std::size_t) noexcept { std::free(memory); }
void operator delete(void* memory, std::align_val_t) noexcept { std::free(memory); }
void operator delete[](void* memory, std::align_val_t) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t, std::align_val_t) noexcept { std::free(memory); }
void operator delete[](void* memory, std::size_t, std::align_val_t) noexcept { std::free(memory); }
void operator delete(void* memory, const std::nothrow_t&) noexcept { std::free(memory); }
void operator delete[](void* memory, const std::nothrow_t&) noexcept { std::free(memory); }
#endif

namespace reeve {
namespace {

class Allocation : public ::testing::Test {
 protected:
  void SetUp() override {
    if (REEVE_UNDER_SANITIZER) GTEST_SKIP() << "the sanitizer counts its own allocations";
  }
};

template <typename Work>
std::uint64_t allocations_in(Work work) {
  const std::uint64_t before = allocations;
  work();
  return allocations - before;
}

GeneratorOptions all_of_five_fingers() {
  return {full_parts(), 5, FingerIdentity::identical, false};
}

std::vector<Routing> actuated() {
  RoutingGenerator generator(all_of_five_fingers());
  std::vector<Routing> routings;
  for (Routing routing; generator.next(routing);) {
    if (is_actuated(routing)) routings.push_back(routing);
  }
  return routings;
}

TEST_F(Allocation, IsCounted) {
  EXPECT_EQ(allocations_in([] {}), 0U);
  static const double* volatile seen = nullptr;  // so that the compiler may not leave it out
  EXPECT_EQ(allocations_in([] {
              const std::vector<double> numbers(100);
              seen = numbers.data();
            }),
            1U);
}

TEST_F(Allocation, HappensInNoEvaluationOnceTheEvaluatorIsWarm) {
  const std::vector<Routing> routings = actuated();
  ASSERT_GT(routings.size(), 20000U);
  DesignEvaluator evaluator(Hardware{}, single_grasps(5));
  double sum = 0;
  const auto pass = [&] {
    for (const Routing& routing : routings) {
      sum += value(evaluator.evaluate(routing), Objective::uniformity_mean);
    }
  };
  const std::uint64_t warming = allocations_in(pass);
  const std::uint64_t warm = allocations_in(pass);
  EXPECT_GT(warming, 0U);
  EXPECT_LT(warming, 1000U);
  EXPECT_EQ(warm, 0U) << "for " << routings.size() << " routings";
  EXPECT_GT(sum, 0);
}

TEST_F(Allocation, HappensInNoGenerationOnceTheGeneratorIsWarm) {
  RoutingGenerator generator(all_of_five_fingers());
  Routing routing;
  std::uint64_t given = 0;
  const auto pass = [&] {
    while (generator.next(routing)) ++given;
  };
  const std::uint64_t warming = allocations_in(pass);
  const std::uint64_t seeking = allocations_in([&] { generator.seek(0); });
  const std::uint64_t warm = allocations_in(pass);
  EXPECT_GT(warming, 0U);
  EXPECT_LT(warming, 1000U);
  EXPECT_EQ(seeking, 0U);
  EXPECT_EQ(warm, 0U);
  EXPECT_EQ(given, 2 * generator.total());
}

}  // namespace
}  // namespace reeve
