#include "pages/shell/result_files.hpp"

#include <utility>

namespace reeve::pages {
namespace {

void add_files(FileBatch& batch, const std::filesystem::path& folder,
               std::vector<ResultFile>& files, const Stamp& stamp) {
  for (ResultFile& file : files) {
    if (file.text) {
      batch.add(folder / file.name, stamped(file.name, std::move(*file.text), stamp));
    } else {
      batch.remove(folder / file.name);
    }
  }
}

}  // namespace

void write_result(const std::filesystem::path& folder, ResultFiles result, const Stamp& stamp) {
  FileBatch batch;
  add_files(batch, folder, result.tables, stamp);
  if (result.figures) add_figures(batch, folder, *result.figures, stamp);
  add_files(batch, folder, result.texts, stamp);
  batch.commit();
}

}  // namespace reeve::pages
