#include <sys/mman.h>
#include <unistd.h>

#include <filesystem>
#include <string>

#include "catalog/model_file.hpp"
#include "catalog/price_file.hpp"
#include "fuzz/fuzzed.hpp"

namespace reeve::fuzz {
namespace {

// A file in memory alone, since settings are read from files.
class MemoryFile {
 public:
  explicit MemoryFile(std::string_view bytes) : descriptor_(memfd_create("settings.toml", 0)) {
    require(descriptor_ >= 0 && write(descriptor_, bytes.data(), bytes.size()) ==
                                    static_cast<ssize_t>(bytes.size()),
            "there is memory for the file");
  }
  MemoryFile(const MemoryFile&) = delete;
  MemoryFile& operator=(const MemoryFile&) = delete;
  ~MemoryFile() { close(descriptor_); }

  std::filesystem::path path() const { return "/proc/self/fd/" + std::to_string(descriptor_); }

 private:
  int descriptor_;
};

catalog::ModelFile model_of(std::string_view bytes) {
  return catalog::read_model_file(MemoryFile(bytes).path());
}

}  // namespace

void settings(std::string_view bytes) {
  or_refused([&] {
    const catalog::ModelFile file = model_of(bytes);
    const std::string written = catalog::model_toml(file.model, {}, file.uncertainty);
    const catalog::ModelFile again = model_of(written);
    require(catalog::model_toml(again.model, {}, again.uncertainty) == written,
            "a model that was written is read as it was");
  });
  or_refused([&] { catalog::read_price_file(MemoryFile(bytes).path()); });
}

}  // namespace reeve::fuzz
