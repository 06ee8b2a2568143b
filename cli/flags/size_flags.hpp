// The options of `size`.
#pragma once

#include <CLI/CLI.hpp>

#include <string>
#include <vector>

#include "cli/flags/table_flags.hpp"
#include "cli/inputs.hpp"
#include "sizing/size.hpp"

namespace reeve::cli {

struct SizeFlags {
  void add_to(CLI::App& command);

  std::vector<std::string> routings;
  std::string from;
  CLI::Option* from_given = nullptr;
  std::size_t top = 20;
  std::vector<std::string> vary;
  std::vector<std::string> same;
  std::string goal = "uniformity*efficiency";
  std::string target;
  CLI::Option* target_given = nullptr;
  std::string grasps = "single";
  CLI::Option* grasps_given = nullptr;
  std::string score = "authors";
  CLI::Option* score_given = nullptr;
  bool nominal = false;
  SizingOptions search;  // draws, seed, starts, evaluations, threads
  std::string save;
  CLI::Option* save_given = nullptr;
  OutOption out;
  ModelOption model;
  TableFlags tables;
  FormatOption format;
};

}  // namespace reeve::cli
