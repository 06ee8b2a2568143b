#include <cstdlib>
#include <new>
#include <vector>

#include "tests/allocation/allocations.hpp"

namespace {
thread_local std::uint64_t calls = 0;
}  // namespace

#if !REEVE_UNDER_SANITIZER
namespace {

void* counted(std::size_t size) noexcept {
  ++calls;
  return std::malloc(size == 0 ? 1 : size);
}

void* counted(std::size_t size, std::align_val_t alignment) noexcept {
  ++calls;
  const auto unit = static_cast<std::size_t>(alignment);
  return std::aligned_alloc(unit, (size + unit) / unit * unit);  // never 0
}

void* or_throw(void* memory) {
  if (memory == nullptr) throw std::bad_alloc();
  return memory;
}

// Not inlined, or else GCC 12 takes it for the wrong end of an operator new that is not.
[[gnu::noinline]] void release(void* memory) { std::free(memory); }

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
void operator delete(void* memory) noexcept { release(memory); }
void operator delete[](void* memory) noexcept { release(memory); }
void operator delete(void* memory, std::size_t) noexcept { release(memory); }
void operator delete[](void* memory, std::size_t) noexcept { release(memory); }
void operator delete(void* memory, std::align_val_t) noexcept { release(memory); }
void operator delete[](void* memory, std::align_val_t) noexcept { release(memory); }
void operator delete(void* memory, std::size_t, std::align_val_t) noexcept { release(memory); }
void operator delete[](void* memory, std::size_t, std::align_val_t) noexcept { release(memory); }
void operator delete(void* memory, const std::nothrow_t&) noexcept { release(memory); }
void operator delete[](void* memory, const std::nothrow_t&) noexcept { release(memory); }
#endif

namespace reeve::testing {

std::uint64_t allocations() { return calls; }

namespace {

TEST_F(Allocation, IsCounted) {
  EXPECT_EQ(allocations_in([] {}), 0U);
  // Read back through a volatile pointer, so that the compiler may not leave the vector out.
  const double* volatile seen = nullptr;
  EXPECT_EQ(allocations_in([&] {
              const std::vector<double> numbers(100, 1.0);
              seen = numbers.data();
              EXPECT_EQ(*seen, 1);
            }),
            1U);
}

}  // namespace
}  // namespace reeve::testing
