// Options that name files, and checks before long work if results may be written, without writing
// anything.
#pragma once

#include <CLI/CLI.hpp>

#include <filesystem>
#include <string>
#include <vector>

#include "numerics/floors.hpp"

namespace reeve::cli {

// A file that a command reads, continues in, or writes by another option, and its role: "the data",
// "the store", "the file of -o".
struct InputFile {
  std::filesystem::path file;
  std::string what;
};

// An option whose value is a text, with the text that it has at first as its default. One that is
// given may be empty.
struct TextOption {
  std::string text{};
  CLI::Option* option = nullptr;

  CLI::Option* add(CLI::App& command, const std::string& name, const std::string& help) {
    option = command.add_option(name, text, help);
    return text.empty() ? option : option->capture_default_str();
  }
  bool is_given() const { return option != nullptr && option->count() > 0; }
  // Lists the file that it names, if it is given.
  void list_in(std::vector<InputFile>& inputs, const std::string& what) const {
    if (is_given()) inputs.push_back({text, what});
  }
  // Checks that the file, if one is given, can be written and is none of those taken, and adds it
  // to them. `name` stands before the value in messages. Throws InputError.
  void claim(const std::string& name, std::vector<InputFile>& taken) const;
};

// The one rule for all commands: nothing is written over what is read, or twice. Files are the same
// where links lead to the same, also while there is none yet. `option` stands before the value in
// messages. Throw InputError.
void require_not_an_input(const std::filesystem::path& file, const std::vector<InputFile>& inputs,
                          const std::string& option);
// Checks the files, and the figures, that are written or removed in the folder of --out.
void require_no_input_in(const std::filesystem::path& folder, const std::vector<InputFile>& inputs);

// The folder, or what there is of the way to it. Throws InputError.
void require_folder_can_be_written(const std::filesystem::path& folder, const std::string& option);

// As write_file would (reports/output/destination.hpp). Throws InputError.
void require_file_can_be_written(const std::filesystem::path& file, const std::string& option);

}  // namespace reeve::cli
