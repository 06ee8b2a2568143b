// Files appear whole or not at all.
#pragma once

#include <filesystem>
#include <string>

#include "numerics/floors.hpp"

namespace reeve::reports {

// Makes the directory and checks that files can be written into it. Throws InputError.
void prepare_directory(const std::filesystem::path& directory, const std::string& option);

// Writes to a temporary name beside it, then renames. Throws InputError that names the file.
void write_file(const std::filesystem::path& file, const std::string& content);

}  // namespace reeve::reports
