// Writes the man page, with --completion the completion of bash, with --options docs/options.md, to
// standard output.
#include <iostream>
#include <string_view>

#include "cli/manual.hpp"
#include "core/version.hpp"

int main(int argc, char** argv) {
  const auto texts = reeve::cli::subcommand_texts();
  const std::string_view what = argc > 1 ? argv[1] : "";
  std::cout << (what == "--completion" ? reeve::cli::bash_completion(texts)
                : what == "--options"  ? reeve::cli::options_document(texts)
                                      : reeve::cli::man_page(texts, reeve::core::version().number));
  std::cout.flush();
  return std::cout ? 0 : 1;
}
