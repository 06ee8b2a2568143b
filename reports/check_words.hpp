// What a checked number is, in words.
#pragma once

#include <string>

#include "catalog/check.hpp"

namespace reeve::reports {

// "T3", "share of T3, %", "reliability"
std::string quantity_text(const CheckedQuantity& quantity);
// The same, or what the number's source calls it.
std::string quantity_text(const CheckItem& item);

}  // namespace reeve::reports
