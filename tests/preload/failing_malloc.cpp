// Loaded before a program (LD_PRELOAD), fails the allocations that the environment names: FAIL_AT=n
// the n-th, with FAIL_ON also all that follow, as where memory is at its end. With FAIL_ABOVE=bytes
// only those of more than that are counted, and fail.
#include <atomic>
#include <cerrno>
#include <cstddef>
#include <cstdlib>

// What glibc's own are made of; dlsym() would itself allocate.
extern "C" {
void* __libc_malloc(std::size_t size) noexcept;
void* __libc_calloc(std::size_t count, std::size_t size) noexcept;
void* __libc_realloc(void* old, std::size_t size) noexcept;
void* __libc_memalign(std::size_t alignment, std::size_t size) noexcept;
}

namespace {

struct Plan {
  long at = 0;
  bool on = false;
  std::size_t above = 0;
};

Plan read_plan() {
  const char* at = std::getenv("FAIL_AT");
  const char* above = std::getenv("FAIL_ABOVE");
  return {at == nullptr ? 0 : std::atol(at), std::getenv("FAIL_ON") != nullptr,
          above == nullptr ? 0 : std::strtoull(above, nullptr, 10)};
}

bool fails(std::size_t size) {
  static std::atomic<long> calls{0};
  static const Plan plan = read_plan();
  if (size <= plan.above) return false;
  const long call = ++calls;
  if (plan.at == 0 || call < plan.at || (call > plan.at && !plan.on)) return false;
  errno = ENOMEM;
  return true;
}

}  // namespace

extern "C" {

void* malloc(std::size_t size) noexcept { return fails(size) ? nullptr : __libc_malloc(size); }

void* calloc(std::size_t count, std::size_t size) noexcept {
  return fails(count * size) ? nullptr : __libc_calloc(count, size);
}

void* realloc(void* old, std::size_t size) noexcept {
  return fails(size) ? nullptr : __libc_realloc(old, size);
}

void* memalign(std::size_t alignment, std::size_t size) noexcept {
  return fails(size) ? nullptr : __libc_memalign(alignment, size);
}

void* aligned_alloc(std::size_t alignment, std::size_t size) noexcept {
  return memalign(alignment, size);
}

int posix_memalign(void** result, std::size_t alignment, std::size_t size) noexcept {
  *result = memalign(alignment, size);
  return *result == nullptr ? ENOMEM : 0;
}

}  // extern "C"
