// Whatever bytes a user or a broken file may give to a reader: each function takes any, and either
// reads them, with what follows from what it read, or refuses them by an InputError or OutOfRange.
// Anything else ends the program: another exception, a law that does not hold, what a sanitizer
// sees.
#pragma once

#include <string_view>
#include <vector>

#include "core/error.hpp"

namespace reeve::fuzz {

void word(std::string_view bytes);      // the notation, canonical form and tensions
void readings(std::string_view bytes);  // measured data
void series(std::string_view bytes);    // a logger's time series
void settings(std::string_view bytes);  // TOML: models, hardware, prices
void options(std::string_view bytes);   // values of options; the first byte chooses which
void store(std::string_view bytes);     // a result store (SQLite)
void shard(std::string_view bytes);     // shard.json

struct NamedReader {
  const char* name;  // and that of its folder in fuzz/corpus
  void (*read)(std::string_view);
};
const std::vector<NamedReader>& readers();

// Ends the program with the sentence if it does not hold.
void require(bool holds, const char* sentence);

template <typename Read>
void or_refused(const Read& read) {
  try {
    read();
  } catch (const core::InputError& error) {
    const core::InputFault& fault = error.fault();
    require(!fault.what.empty() || !fault.expected.empty() || !fault.parts.empty(),
            "a refusal says what is wrong or what was expected");
  } catch (const core::OutOfRange&) {
  }
}

}  // namespace reeve::fuzz
