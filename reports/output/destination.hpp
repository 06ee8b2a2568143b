// Destination of a file that the user names: the one rule for all that is written.
//
//   regular file, or none yet   replaced by another one of the same permissions (files.hpp)
//   symbolic link               what it leads to, which need not be there; the link stays
//   device, pipe                written through, never replaced
//   descriptor of this process  (/dev/stdout, /dev/fd/3, /proc/self/fd/3) written to as it is open
#pragma once

#include <sys/types.h>

#include <filesystem>
#include <optional>
#include <system_error>

#include "numerics/floors.hpp"

namespace reeve::reports {

struct ReplacedFile {
  mode_t mode = 0;
  uid_t owner = 0;
  gid_t group = 0;
};

struct Destination {
  std::filesystem::path file;       // no link
  std::optional<int> descriptor{};  // open in this process
  bool written_through = false;
  std::optional<ReplacedFile> replaced{};  // permissions and owner of the existing file
  std::error_code error{};                 // why nothing can be written there
};

Destination destination(const std::filesystem::path& named);

}  // namespace reeve::reports
