// The subcommands for callers that are no shell: options as they would be given to it, read and
// checked by the same code and with the same defaults, and values in place of what is printed.
//
// What is wrong with an option is an InputError, also where the shell would be told in CLI11's
// words. A study that was stopped gives what it has, or nothing.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/error.hpp"
#include "reports/exploration/count_report.hpp"
#include "reports/exploration/explore_report.hpp"
#include "studies/check.hpp"
#include "studies/comparison_study.hpp"
#include "studies/diagnosis_study.hpp"
#include "studies/import_study.hpp"
#include "studies/ranking_study.hpp"
#include "studies/shown_routing.hpp"
#include "studies/simulation_study.hpp"
#include "studies/sizing_study.hpp"
#include "studies/stored_ranking.hpp"
#include "studies/study_supervision.hpp"

namespace reeve::cli {

// Of an option that CLI11 refuses: its words, and the parts that they are made of.
class OptionError : public InputError {
 public:
  OptionError(const std::string& words, InputFault option)
      : InputError(words), option_(std::move(option)) {}

  const InputFault& option() const { return option_; }

 private:
  InputFault option_;
};

// Without the subcommand's name: "--fingers=3", "TR7".
using Arguments = std::vector<std::string>;

ExploreReport asked_exploration(const Arguments& arguments, const StudySupervision& supervision);
// With all that its page shows.
std::optional<RankReport> asked_ranking(const Arguments& arguments,
                                        const StudySupervision& supervision);
// Of what rank --store names: by the options that it takes.
StoredRanking asked_stored_ranking(const Arguments& arguments);
// With what of the shards' arguments decides.
struct MergedExploration {
  ExploreReport report;
  Arguments arguments;
};
MergedExploration asked_merge(const Arguments& arguments, const StudySupervision& supervision);
SizingReport asked_sizing(const Arguments& arguments, const StudySupervision& supervision);
std::optional<DiagnosisReport> asked_diagnosis(const Arguments& arguments,
                                               const StudySupervision& supervision);
ShownRouting asked_routing(const Arguments& arguments);
CountReport asked_count(const Arguments& arguments);
CheckReport asked_check(const Arguments& arguments);
CompareReport asked_comparison(const Arguments& arguments);
// With the command that makes them again.
struct AskedReadings {
  ImportReport report;
  std::string command;
};
AskedReadings asked_import(const Arguments& arguments);
SimulationReport asked_simulation(const Arguments& arguments);
std::optional<PowerReport> asked_power(const Arguments& arguments,
                                       const StudySupervision& supervision);

// The files that the program writes into the folder of --out, which is among the arguments.
void write_asked(const ExploreReport& report, const Arguments& arguments);
void write_asked(const MergedExploration& merged, const Arguments& arguments);
void write_asked(const RankReport& report, const Arguments& arguments);
void write_asked(SizingReport report, const Arguments& arguments);
void write_asked(const DiagnosisReport& report, const Arguments& arguments);
void write_asked(const ShownRouting& report, const Arguments& arguments);
void write_asked(const CompareReport& report, const Arguments& arguments);

// The model file of diagnose --save-model, and the hardware file of size --save-hardware.
std::string asked_model_toml(const DiagnosisReport& report, const Arguments& arguments);
std::string asked_hardware_toml(const SizingReport& report, const Arguments& arguments);

// As `reeve SUBCOMMAND --help` has them; none of a subcommand that there is not.
struct OptionText {
  std::string name;  // "fingers"; of a positional "routing"
  std::string preset;
  std::string meaning;
  bool is_flag = false;
};
std::vector<OptionText> option_texts(const std::string& subcommand);

}  // namespace reeve::cli
