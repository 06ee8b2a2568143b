#include "tests/support/sanitizers.hpp"

namespace reeve::testing {

bool has_sanitizer() {
#if defined(REEVE_SANITIZED) || defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
  return true;
#else
  return false;
#endif
}

}  // namespace reeve::testing
