#include "pages/shell/result_files.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <algorithm>
#include <array>
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
bool is_of_earlier_run(const std::filesystem::path& file) {
  std::error_code ignored;
  if (!std::filesystem::is_regular_file(file, ignored)) return false;
  constexpr std::size_t any_size = std::numeric_limits<std::size_t>::max() / 2;
  const std::string text = read_input(file, any_size, "a file");
  return std::ranges::any_of(std::array{exploration_kind, result_kind}, [&](const char* kind) {
    return !id_in(file.filename(), text, kind).empty();
  });
}

void add_files(FileBatch& batch, const std::filesystem::path& folder,
               std::vector<ResultFile>& files, const Stamp& stamp) {
  for (ResultFile& file : files) {
    batch.add(folder / file.name, stamped(file.name, std::move(file.text), stamp));
  }
}

void remove_others(FileBatch& batch, const std::filesystem::path& folder,
                   const ResultFiles& result) {
  const auto is_among = [](const std::vector<ResultFile>& files, const std::string& name) {
    return std::ranges::find(files, name, &ResultFile::name) != files.end();
  };
  for (const std::string& name : result_names()) {
    if (is_among(result.tables, name) || is_among(result.texts, name)) continue;
    if (is_of_earlier_run(folder / name)) batch.remove(folder / name);
  }
}

}  // namespace

std::vector<std::string> result_names() {
  return {"designs.csv",   "pareto.csv", "sample.csv",     "tradeoff.csv",    "sweep.csv",
          "residuals.csv", "shard.json", "summary.json",   "ranking.json",    "routing.json",
          "sizing.json",   "index.html", "catalogue.json", "comparison.json", "diagnosis.json"};
}

void write_result(const std::filesystem::path& folder, ResultFiles result, const Stamp& stamp) {
  const FolderLock lock(folder);
  FileBatch batch;
  remove_others(batch, folder, result);
  add_files(batch, folder, result.tables, stamp);
  add_figures(batch, folder, result.figures, stamp);
  add_files(batch, folder, result.texts, stamp);
  batch.commit();
}

void write_result(const std::filesystem::path& folder, PageFiles page, const ResultFile& json,
                  std::vector<ResultFile> tables) {
  write_result(
      folder,
      {std::move(tables), std::move(page.figures), {{"index.html", std::move(page.html)}, json}},
      result_stamp(json.text));
}

}  // namespace reeve::pages
