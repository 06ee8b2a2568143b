#include "cli/api.hpp"

namespace reeve::cli {

std::vector<OptionText> api::option_texts(const std::string& subcommand) {
  for (SubcommandText& text : subcommand_texts()) {
    if (text.name == subcommand) return std::move(text.options);
  }
  return {};
}

}  // namespace reeve::cli
