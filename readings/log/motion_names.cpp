#include "readings/log/motion_names.hpp"

#include <algorithm>
#include <array>
#include <string>

#include "readings/units.hpp"
#include "readings/words.hpp"

namespace reeve::readings {
namespace {

constexpr std::array words_of_motion{"position", "pos",          "speed", "velocity",
                                     "vel",      "displacement", "travel"};

bool is_one(std::string_view text, Dimension dimension) {
  return find_unit(text, dimension).has_value();
}

}  // namespace

bool says_motion(std::string_view name) {
  const NameWords words = words_of(name);
  return std::any_of(words.words.begin(), words.words.end(), [](const std::string& word) {
    return std::find(words_of_motion.begin(), words_of_motion.end(), word) != words_of_motion.end();
  });
}

bool has_unit_of_motion(std::string_view name) {
  const NameWords words = words_of(name);
  if (words.bracketed) {
    return is_one(*words.bracketed, Dimension::length) ||
           is_one(*words.bracketed, Dimension::speed);
  }
  const std::size_t count = words.words.size();
  if (count < 2) return false;
  const std::string& last = words.words[count - 1];
  // A lone m or in may be another word.
  const bool is_length = last == "mm" || last == "cm";
  return is_length || (count > 2 && is_one(words.words[count - 2] + "/" + last, Dimension::speed));
}

}  // namespace reeve::readings
