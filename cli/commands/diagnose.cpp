#include <fmt/format.h>

#include <atomic>
#include <filesystem>
#include <iostream>
#include <string>
#include <vector>

#include "catalog/model_file.hpp"
#include "cli/api.hpp"
#include "cli/command_line.hpp"
#include "cli/commands/commands.hpp"
#include "cli/flags/reading_flags.hpp"
#include "cli/inputs.hpp"
#include "cli/outputs.hpp"
#include "cli/printing.hpp"
#include "cli/supervision.hpp"
#include "core/error.hpp"
#include "pages/diagnosis/diagnosis_page.hpp"
#include "pages/shell/result_files.hpp"
#include "readings/csv.hpp"
#include "reports/diagnosis/diagnosis_report.hpp"
#include "reports/output/files.hpp"
#include "reports/output/shell_word.hpp"
#include "studies/diagnosis_study.hpp"
#include "studies/tension_distributions.hpp"

namespace reeve::cli {
namespace {

constexpr std::size_t most_replicates = 100000;
constexpr double least_alpha = 0.0001;
static_assert(least_replicates(least_alpha) <= most_replicates);

struct DiagnoseFlags {
  std::string data;
  DiagnosisSettings settings;
  bool generated_routings = false;
  bool as_readings = false;
  int threads = 0;
  OutOption out;
  TextOption save_model;
  TextOption terms;
  CLI::Option* replicates_given = nullptr;
  ReadingFlags readings;
  HardwareOption hardware;
  FormatOption format;

  std::filesystem::path page_file() const { return std::filesystem::path(out.text) / "index.html"; }
};

// Fewer than alpha needs are refused; where nobody says how many, there are enough.
DiagnosisSettings settings(const DiagnoseFlags& flags) {
  DiagnosisSettings settings = flags.settings;
  const std::size_t least = least_replicates(settings.alpha);
  if (settings.replicates >= least) return settings;
  if (flags.replicates_given->count() > 0) {
    throw InputError({.what = "--replicates",
                      .value = std::to_string(settings.replicates),
                      .expected = fmt::format("at least {}: with fewer no p-value falls below what "
                                              "--alpha {:g} asks for",
                                              least, settings.alpha)});
  }
  settings.replicates = least;
  return settings;
}

// Before the long work.
void require_places(const DiagnoseFlags& flags) {
  std::vector<InputFile> inputs{{flags.data, "the data"}};
  flags.hardware.list_in(inputs, "the hardware");
  flags.terms.list_in(inputs, "the terms");
  flags.save_model.claim("--save-model", inputs);
  if (!flags.out.is_given()) return;
  require_folder_can_be_written(flags.out.text, "--out");
  if (std::filesystem::is_directory(flags.out.text)) {
    require_file_can_be_written(flags.page_file(), "--out");
  }
  flags.out.require_apart_from(inputs);
}

// Thousands of samples would be taken for as many readings, and chance for certainty.
void require_readings(const MeasuredData& data) {
  for (const DataNote& note : data.notes) {
    if (note.kind != NoteKind::time_series) continue;
    throw InputError(
        {.where = data.file,
         .what = note.text,
         .expected = fmt::format("steady readings, which reeve import {} -o readings.csv makes of "
                                 "it; or --as-readings, if each row is a reading of its own",
                                 shell_word(for_message(data.file)))});
  }
}

// `stage` hears what is being done. Nothing if it was stopped.
std::optional<DiagnosisReport> report(const DiagnoseFlags& flags, const Catalogue& catalogue,
                                      const std::function<void(const char*)>& stage,
                                      const std::atomic<bool>* stop) {
  DiagnosisRequest request;
  request.hardware = flags.hardware.read().hardware;
  request.settings = settings(flags);
  if (flags.terms.is_given()) {
    request.settings.terms = read_terms_file(flags.terms.text, catalogue);
  }
  request.with_generated = flags.generated_routings;
  request.threads = flags.threads;
  request.data = flags.readings.read(flags.data, catalogue);
  if (!flags.as_readings) require_readings(request.data);
  std::vector<Routing> routings;
  for (const MeasuredRouting& measured : request.data.routings) {
    routings.push_back(measured.routing);
  }
  require_hardware_to_fit(request.hardware, routings);
  require_values_to_act(request.hardware, routings);
  require_places(flags);
  request.stage = stage;
  request.stop = stop;
  return diagnosis_study(std::move(request), catalogue);
}

DiagnosisReport watched_report(const DiagnoseFlags& flags, const Catalogue& catalogue) {
  const std::atomic<bool>& stop = stop_on_interrupt();
  StatusLine line;
  auto result = report(
      flags, catalogue, [&](const char* stage) { line.show(stage); }, &stop);
  if (!result) throw Interrupted();
  return std::move(*result);
}

std::string command_text(const CLI::App& command) {
  return command_line(command, {"--threads", "--format"});
}

void write_folder(const DiagnosisReport& report, const DiagnoseFlags& flags,
                  const std::string& command, const Catalogue& catalogue) {
  const PageFiles page =
      diagnosis_page({report, command, next_routing(report, catalogue),
                      diagnosed_distributions(report.data, report.hardware, report.result,
                                              report.published, catalogue)});
  prepare_directory(flags.out.text, "--out");
  write_result(flags.out.text, page, {"diagnosis.json", diagnosis_json(report)},
               {{"residuals.csv", diagnosis_residuals_csv(report)}});
}

std::string model_toml(const DiagnosisReport& report, const DiagnoseFlags& flags) {
  return extended_model_toml(report, flags.hardware.read().uncertainty);
}

int run(const DiagnoseFlags& flags, const CLI::App& command) {
  const Catalogue catalogue = shipped_catalogue();
  const DiagnosisReport result = watched_report(flags, catalogue);
  if (flags.out.is_given()) {
    write_folder(result, flags, command_text(command), catalogue);
  }
  if (flags.save_model.is_given()) {
    write_file(flags.save_model.text, model_toml(result, flags));
  }
  std::cout << (flags.format.is("json") ? diagnosis_json(result)
                                        : printed(diagnosis_document(result), flags.format));
  if (flags.out.is_given()) {
    std::cout << announced("index.html, diagnosis.json, residuals.csv and figures", flags.out.text,
                           flags.format);
  }
  return result.result.verdict == Verdict::too_few ? answer_is_no : done;
}

void add_settings(CLI::App& command, DiagnoseFlags& flags) {
  DiagnosisSettings& settings = flags.settings;
  add_with_default(command, "--alpha", settings.alpha,
                   "Significance level of a coefficient that differs; a quarter of it for "
                   "further structure")
      ->check(number_from(least_alpha, 0.5));
  add_with_default(
      command, "--hold-out", settings.hold_out,
      "Share of the runs held out from the search, for a final test of the gain (0: cross-validation)")
      ->check(number_from(0, 0.9));
  add_with_default(command, "--seed", settings.seed,
                   "Seed of the folds of runs and of simulated data sets")
      ->check(is_seed);
  flags.replicates_given =
      add_with_default(command, "--replicates", settings.replicates,
                       "Number of simulated data sets by which findings are judged; at least 8 / "
                       "alpha")
          ->check(CLI::Range(std::size_t{99}, most_replicates));
  command
      .add_option(
          "--mounting-scatter", settings.mounting_scatter,
          "Relative scatter of friction exponents between mountings, such as 0.05 (default: "
          "estimated)")
      ->check(number_from(0, 1));
  flags.terms
      .add(command, "--terms",
           "TOML file with laws, [[law]] as in a model file, that the search tries besides its "
           "causes")
      ->check(names_a_file);
  command.add_flag("--as-readings", flags.as_readings,
                   "Take each row as a reading even where the file looks like a time series");
  command.add_flag("--generated-routings", flags.generated_routings,
                   "Propose generated routings too for the next measurement, besides those of "
                   "catalogue and data");
}

void add_options(CLI::App& command, DiagnoseFlags& flags) {
  command
      .add_option("data", flags.data, "CSV file of readings; docs/data.md describes its columns")
      ->check(names_a_file)
      ->required();
  add_settings(command, flags);
  add_threads(command, flags.threads);
  flags.out.add_to(command, "index.html, figures/, diagnosis.json and residuals.csv");
  flags.save_model.add(
      command, "--save-model",
      "TOML file for the extended model, which rank, explore and show take as --model");
  flags.readings.add_to(command);
  flags.readings.add_noise_to(command);
  flags.hardware.add_to(command);
  flags.format.add_to(command, with_tables({"json"}));
}

constexpr Subcommand<DiagnoseFlags> diagnose_command{
    "diagnose",
    "Find the cause of the residuals of measured tensions, extend the model by it, and propose the next measurement",
    add_options, run};

}  // namespace

void add_diagnose(CLI::App& program, int& exit_code) {
  diagnose_command.add_to(program, exit_code);
}

std::optional<DiagnosisReport> api::diagnose(const Arguments& arguments,
                                             const StudySupervision& supervision) {
  const auto parsed = diagnose_command.parsed(arguments);
  const auto tell = [&](const char* stage) {
    if (supervision.report) supervision.report(stage, {});
  };
  return report(parsed.flags(), shipped_catalogue(), tell, supervision.stop);
}

void api::write(const DiagnosisReport& report, const Arguments& arguments) {
  const auto parsed = diagnose_command.parsed(arguments);
  require_places(parsed.flags());
  write_folder(report, parsed.flags(), command_text(parsed.command()), shipped_catalogue());
}

std::string api::model_toml(const DiagnosisReport& report, const Arguments& arguments) {
  return cli::model_toml(report, diagnose_command.parsed(arguments).flags());
}

}  // namespace reeve::cli
