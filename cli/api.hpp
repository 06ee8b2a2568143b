// The subcommands for callers that are no shell: options as they would be given to it, read and
// checked by the same code and with the same defaults, and values in place of what is printed.
//
// A bad option throws InputError, also where the shell would be told in CLI11's words. A study that
// was stopped gives what it has, or nothing.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "cli/option_texts.hpp"
#include "core/error.hpp"
#include "reports/exploration/explore_report.hpp"
#include "reports/exploration/part_words.hpp"
#include "studies/catalogue_check.hpp"
#include "studies/catalogue_list.hpp"
#include "studies/comparison_study.hpp"
#include "studies/diagnosis_study.hpp"
#include "studies/import_study.hpp"
#include "studies/ranking_study.hpp"
#include "studies/shown_routing.hpp"
#include "studies/simulation_study.hpp"
#include "studies/sizing_study.hpp"
#include "studies/stored_ranking.hpp"
#include "studies/study_supervision.hpp"

namespace reeve::cli::api {

// CLI11 refuses an option: its words, and the parts that they are made of.
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

ExploreReport explore(const Arguments& arguments, const StudySupervision& supervision);
// With all that its page shows.
std::optional<RankReport> rank(const Arguments& arguments, const StudySupervision& supervision);
// Ranks the designs of a store, by the options that rank takes with --store.
StoredRanking rank_stored(const Arguments& arguments);
// With what of the shards' arguments decides.
struct MergedExploration {
  ExploreReport report;
  Arguments arguments;
};
MergedExploration merge(const Arguments& arguments, const StudySupervision& supervision);
SizingReport size(const Arguments& arguments, const StudySupervision& supervision);
std::optional<DiagnosisReport> diagnose(const Arguments& arguments,
                                        const StudySupervision& supervision);
ShownRouting show(const Arguments& arguments);
CountReport count(const Arguments& arguments);
CheckReport check(const Arguments& arguments);
struct ListedCatalogue {
  std::vector<ListedMechanism> mechanisms;
};
ListedCatalogue catalogue(const Arguments& arguments);
CompareReport compare(const Arguments& arguments);
// With the command that makes them again.
struct ImportedReadings {
  ImportReport report;
  std::string command;
};
ImportedReadings import_log(const Arguments& arguments);
SimulationReport simulate(const Arguments& arguments);
std::optional<PowerReport> power(const Arguments& arguments, const StudySupervision& supervision);

// The files that the program writes into the folder of --out, which is among the arguments.
void write(const ExploreReport& report, const Arguments& arguments);
void write(const MergedExploration& merged, const Arguments& arguments);
void write(const RankReport& report, const Arguments& arguments);
void write(SizingReport report, const Arguments& arguments);
void write(const DiagnosisReport& report, const Arguments& arguments);
void write(const ShownRouting& report, const Arguments& arguments);
void write(const ListedCatalogue& catalogue, const Arguments& arguments);
void write(const CompareReport& report, const Arguments& arguments);

// The model file of diagnose --save-model, and the hardware file of size --save-hardware.
std::string model_toml(const DiagnosisReport& report, const Arguments& arguments);
std::string hardware_toml(const SizingReport& report, const Arguments& arguments);

// Returns no options for an unknown subcommand.
std::vector<OptionText> option_texts(const std::string& subcommand);

}  // namespace reeve::cli::api
