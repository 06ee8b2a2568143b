// Files appear whole or not at all, and nothing but regular files is replaced (destination.hpp).
#pragma once

#include <atomic>
#include <filesystem>
#include <stdexcept>
#include <string>
#include <vector>

#include "numerics/floors.hpp"
#include "reports/destination.hpp"

namespace reeve::reports {

// Whoever handles signals wanted the end while a pipe had no reader yet.
class WaitInterrupted : public std::runtime_error {
 public:
  explicit WaitInterrupted(const std::filesystem::path& file)
      : std::runtime_error("interrupted: nobody reads '" + file.string() + "'") {}
};

// From here on a pipe that nobody reads is waited for no longer than until that is true. A signal
// alone does not end a wait: it may come between two looks at the pipe, or meet another thread.
void end_waits_on(const std::atomic<bool>* stop);

// Makes the directory and checks that files can be written into it. Throws InputError.
void prepare_directory(const std::filesystem::path& directory, const std::string& option);

// Files that belong together. Each is written under a temporary name beside its own; then, all at
// once, those to be removed go, and the others appear in the order in which they were added. What
// fails or runs out of memory before leaves what was there as it was.
class FileBatch {
 public:
  FileBatch() = default;
  FileBatch(const FileBatch&) = delete;
  FileBatch& operator=(const FileBatch&) = delete;
  ~FileBatch();

  // Both throw InputError that names the file.
  void add(const std::filesystem::path& file, const std::string& content);
  void commit();

  // What is not there need not go; of a link goes what it leads to.
  void remove(const std::filesystem::path& file);

 private:
  struct Entry {
    std::filesystem::path named;
    Destination there;
    std::filesystem::path temporary;  // empty once it has its name, or if it is written through
    std::string content;              // only of what is written through
  };

  std::vector<std::filesystem::path> removed_;
  std::vector<Entry> entries_;
};

// A batch of one.
void write_file(const std::filesystem::path& file, const std::string& content);

}  // namespace reeve::reports
