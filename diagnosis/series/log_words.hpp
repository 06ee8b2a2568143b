// A column of a log that has words: the labels of its samples, or a clock on the wall.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "numerics/floors.hpp"

namespace reeve::diagnosis {

class LogWords {
 public:
  // Of the next samples.
  void add(std::string_view word, std::size_t samples = 1);

  std::size_t size() const { return ids_.size(); }
  // Equal for equal words.
  std::uint32_t id(std::size_t sample) const { return ids_[sample]; }
  const std::string& word(std::size_t sample) const { return *words_[ids_[sample]]; }

  // Of samples: in how many the word is another than in the one before.
  std::size_t changes() const;
  // Whether every word is a time of day, alone or behind a date.
  bool has_times_of_day() const;

 private:
  std::map<std::string, std::uint32_t, std::less<>> known_;
  std::vector<const std::string*> words_;  // by id
  std::vector<std::uint32_t> ids_;
};

}  // namespace reeve::diagnosis
