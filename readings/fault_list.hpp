// All faults of one file, so that the user can fix them at once: the first ones in the order of
// their lines, and the number of each kind.
//
// Memory does not grow with the number of faults.
#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <vector>

#include "core/error.hpp"

namespace reeve::readings {

inline constexpr std::size_t most_listed_faults = 20;

struct LineFault {
  std::size_t line = 0;
  InputFault fault;
};

class FaultList {
 public:
  // Faults are counted by `kind`: "in column 'T1_N'".
  void add(std::size_t line, const std::string& kind, InputFault fault);
  void add(const FaultList& others);

  std::size_t count() const { return count_; }
  // Throws InputError: the fault itself if there is one alone, one with parts if there are several,
  // nothing if there are none.
  void throw_any(const std::string& file) const;

 private:
  std::string head() const;

  std::vector<LineFault> first_;  // sorted by line
  std::map<std::string, std::size_t> kinds_;
  std::size_t count_ = 0;
};

}  // namespace reeve::readings
