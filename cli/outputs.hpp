// Where results may be written: checked before long work, without writing anything.
#pragma once

#include <filesystem>
#include <string>

#include "numerics/floors.hpp"

namespace reeve::cli {

// The data cannot be measured again. `option` stands before the value in messages.
void require_not_the_data(const std::filesystem::path& file, const std::filesystem::path& data,
                          const std::string& option);

// The folder, or what there is of the way to it. Throws InputError.
void require_folder_can_be_written(const std::filesystem::path& folder, const std::string& option);

// As write_file would (reports/destination.hpp). Throws InputError.
void require_file_can_be_written(const std::filesystem::path& file, const std::string& option);

}  // namespace reeve::cli
