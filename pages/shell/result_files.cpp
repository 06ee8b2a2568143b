#include "pages/shell/result_files.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#include <ctime>
#include <limits>
#include <utility>

#include "core/error.hpp"
#include "core/input_file.hpp"

namespace reeve::pages {
namespace {

// Two runs write into one folder one after the other, so that the later result is whole. If the
// file system knows no such lock, there is none.
class FolderLock {
 public:
  explicit FolderLock(const std::filesystem::path& folder)
      : descriptor_(::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC)) {
    constexpr timespec between{0, 10'000'000};
    constexpr int most_waits = 1000;
    for (int waits = 0; ::flock(descriptor_, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK;
         ++waits) {
      if (waits == most_waits) refuse(folder);
      ::nanosleep(&between, nullptr);
    }
  }
  FolderLock(const FolderLock&) = delete;
  FolderLock& operator=(const FolderLock&) = delete;
  ~FolderLock() {
    if (descriptor_ >= 0) ::close(descriptor_);
  }

 private:
  [[noreturn]] void refuse(const std::filesystem::path& folder) const {
    ::close(descriptor_);
    throw InputError({.where = folder.string(), .what = "another process is writing into it"});
  }

  int descriptor_;
};

// A file of the same name that somebody else put there stays.
bool is_of_earlier_run(const std::filesystem::path& file, const std::string& kind) {
  std::error_code ignored;
  if (!std::filesystem::is_regular_file(file, ignored)) return false;
  constexpr std::size_t any_size = std::numeric_limits<std::size_t>::max() / 2;
  return !id_in(file.filename(), read_input(file, any_size, "a file"), kind).empty();
}

void add_files(FileBatch& batch, const std::filesystem::path& folder,
               std::vector<ResultFile>& files, const Stamp& stamp) {
  for (ResultFile& file : files) {
    if (file.text) {
      batch.add(folder / file.name, stamped(file.name, std::move(*file.text), stamp));
    } else if (is_of_earlier_run(folder / file.name, stamp.kind)) {
      batch.remove(folder / file.name);
    }
  }
}

}  // namespace

void write_result(const std::filesystem::path& folder, ResultFiles result, const Stamp& stamp) {
  const FolderLock lock(folder);
  FileBatch batch;
  add_files(batch, folder, result.tables, stamp);
  if (result.figures) add_figures(batch, folder, *result.figures, stamp);
  add_files(batch, folder, result.texts, stamp);
  batch.commit();
}

void write_result(const std::filesystem::path& folder, PageFiles page, const ResultFile& json,
                  std::vector<ResultFile> tables) {
  write_result(
      folder,
      {std::move(tables), std::move(page.figures), {{"index.html", std::move(page.html)}, json}},
      result_stamp(*json.text));
}

}  // namespace reeve::pages
