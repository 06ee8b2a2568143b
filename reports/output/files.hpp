// Files appear whole or not at all, and nothing but regular files is replaced (destination.hpp).
#pragma once

#include <filesystem>
#include <string>
#include <system_error>
#include <vector>

#include "numerics/floors.hpp"
#include "reports/output/destination.hpp"

namespace reeve::reports {

// Makes the directory and checks that files can be written into it. Throws InputError.
void prepare_directory(const std::filesystem::path& directory, const std::string& option);

// Files that belong together. Each is written under a temporary name beside its own. Then the old
// ones go, those to be replaced and those to be removed, the last of the batch first; and the new
// ones appear in the order in which they were added. So a kill leaves old files or new ones, never
// some of both, and where the last file is, all are. A single file is replaced in one step. A
// failure or lack of memory before that leaves the old files as they were.
class FileBatch {
 public:
  FileBatch() = default;
  FileBatch(const FileBatch&) = delete;
  FileBatch& operator=(const FileBatch&) = delete;
  ~FileBatch();

  // Both throw InputError that names the file.
  void add(const std::filesystem::path& file, const std::string& content);
  void commit();

  // A file that is not there is no error. A link is removed itself, not the file that it leads to.
  void remove(const std::filesystem::path& file);

 private:
  struct Entry {
    std::filesystem::path named;
    Destination there;
    std::filesystem::path temporary;  // empty once it has its name, or if it is written through
    std::string content;              // only of what is written through
    bool is_removed = false;

    bool is_regular() const { return is_removed || !temporary.empty(); }
  };

  void require_alone(const Entry& entry) const;
  void take_old_away() const;
  static std::error_code appear(Entry& entry);

  std::vector<Entry> entries_;
};

// A batch of one.
void write_file(const std::filesystem::path& file, const std::string& content);

}  // namespace reeve::reports
