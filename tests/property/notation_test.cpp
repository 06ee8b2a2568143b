#include "core/notation.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <string>

#include "core/error.hpp"
#include "tests/property/any_routing.hpp"

namespace reeve {
namespace {

RC_GTEST_PROP(NotationProperty, ParsingAndPrintingRoundTrip, ()) {
  const Routing routing = *testing::any_angled_routing();
  const std::string word = to_word(routing);
  RC_ASSERT(parse_routing(word) == routing);
  RC_ASSERT(to_word(parse_routing(word)) == word);
}

// Whether the text is read at all, and if so, that it is printed as it was.
bool reads_as_written_or_refuses(const std::string& text) {
  try {
    return to_word(parse_routing(text)) == text;
  } catch (const InputError& error) {
    return std::string(error.what()).rfind("routing '", 0) == 0;
  }
}

RC_GTEST_PROP(NotationProperty, AnyBytesAreReadAsWrittenOrRefusedByName, ()) {
  RC_ASSERT(reads_as_written_or_refuses(*rc::gen::arbitrary<std::string>()));
}

RC_GTEST_PROP(NotationProperty, AnyTextOfTheAlphabetIsReadAsWrittenOrRefusedByName, ()) {
  RC_ASSERT(reads_as_written_or_refuses(
      *rc::gen::container<std::string>(rc::gen::elementOf(std::string("MFTBP12-+bxY/0.")))));
}

RC_GTEST_PROP(NotationProperty, AWordWithOneByteChangedIsReadAsWrittenOrRefusedByName, ()) {
  std::string word = to_word(*testing::any_angled_routing());
  word[*rc::gen::inRange<std::size_t>(0, word.size())] =
      *rc::gen::elementOf(std::string("MFTBP123-+b?/."));
  RC_ASSERT(reads_as_written_or_refuses(word));
}

}  // namespace
}  // namespace reeve
