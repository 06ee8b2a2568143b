// Writes the man page, or with --completion the completion of bash, to standard output: what the
// build installs of the program's options.
#include <iostream>
#include <string_view>

#include "cli/manual.hpp"
#include "core/version.hpp"

int main(int argc, char** argv) {
  const auto texts = reeve::cli::subcommand_texts();
  const bool completion = argc > 1 && std::string_view(argv[1]) == "--completion";
  std::cout << (completion ? reeve::cli::bash_completion(texts)
                           : reeve::cli::man_page(texts, reeve::core::version().number));
  std::cout.flush();
  return std::cout ? 0 : 1;
}
