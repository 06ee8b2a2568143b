// Which words of mechanisms make sense: for the random ones.
#pragma once

#include <string>

namespace reeve::testing {

// Whether it names that many blocks, cannot lock and, with all fingers free, moves as the reference
// model understands it.
bool is_sound_mechanism(const std::string& word, int blocks);

}  // namespace reeve::testing
