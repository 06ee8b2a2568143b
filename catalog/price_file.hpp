// Reads a price file (TOML): what each kind of part costs. catalog/prices/example.toml shows every
// key. `bearing` is the price of every part that turns on a bearing and has none of its own; what
// is not given otherwise costs nothing, but something must be.
#pragma once

#include <filesystem>

#include "core/part_prices.hpp"

namespace reeve::catalog {

// Throws InputError with file, line, column, key, value and what was expected.
PartPrices read_price_file(const std::filesystem::path& path);

}  // namespace reeve::catalog
