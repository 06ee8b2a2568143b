#include "core/version.hpp"

#include "generated/version_info.hpp"  // written by cmake/version.cmake on every build

namespace reeve::core {

Version version() { return {REEVE_VERSION_NUMBER, REEVE_VERSION_COMMIT}; }

}  // namespace reeve::core
