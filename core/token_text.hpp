// One token of a word, read and printed.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "core/routing.hpp"

namespace reeve::core {

// A token that stands at an end of its walk, or inside it: Y1 and W1 mean another thing there.
enum class TokenPlace { end, inside };

// `column` is where the token stands in the word. Throws InputError.
Token read_token(std::string_view word, std::string_view text, std::size_t column,
                 TokenPlace place);

void print_token(std::string& word, const Token& token);

}  // namespace reeve::core
