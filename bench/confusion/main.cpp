// How often a diagnosis is right, on data whose cause is known: plants data sets, diagnoses each,
// and prints confusion matrices and the rates that are required of it. The result depends on the
// seed and not on the number of threads.
#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <atomic>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <fstream>
#include <map>
#include <string>
#include <vector>

#include "bench/confusion/foreign.hpp"
#include "bench/confusion/report.hpp"
#include "bench/confusion/trial.hpp"
#include "numerics/parallel.hpp"

namespace reeve::bench {
namespace {

struct Options {
  std::size_t sets = 180;  // data sets of each part
  std::uint64_t seed = 1;
  std::string part = "all";
  double visible = 20;
  int threads = 0;
  bool list = false;
  std::uint64_t only = 0;      // this data set alone, by the number that the list gives it
  std::filesystem::path save;  // folder for the data sets that were missed
  DiagnoseOptions diagnosis;
};

std::vector<Outcome> run_all(const std::vector<Trial>& trials, const Options& options) {
  DiagnoseOptions diagnosis = options.diagnosis;
  diagnosis.threads = 1;
  std::vector<Outcome> outcomes(trials.size());
  std::atomic<std::size_t> done = 0;
  Workers(options.threads).for_each_block(trials.size(), 1, [&](const IndexBlock& block) {
    for (std::size_t i = block.begin; i < block.end; ++i) {
      outcomes[i] = run(trials[i], diagnosis);
      fmt::print(stderr, "\r{} {} of {}", part_name(trials[i].part), ++done, trials.size());
    }
  });
  fmt::print(stderr, "\n");
  return outcomes;
}

void save_missed(const std::vector<Outcome>& outcomes, const Options& options) {
  std::filesystem::create_directories(options.save);
  for (const Outcome& outcome : outcomes) {
    if (as_it_should_be(outcome)) continue;
    const std::string file =
        fmt::format("{}_{}.csv", part_name(outcome.trial.part), outcome.trial.seed);
    std::ofstream(options.save / file) << outcome.csv;
  }
}

void run_part(Part part, const Options& options) {
  std::vector<Trial> trials = trials_of(part, options.sets, options.seed);
  if (options.only != 0) {
    std::erase_if(trials, [&](const Trial& trial) { return trial.seed != options.only; });
  }
  const auto outcomes = run_all(trials, options);
  fmt::print("{}", report(part, outcomes, options.visible));
  if (options.list) fmt::print("Missed:\n\n{}\n", misses(outcomes, options.visible));
  if (!options.save.empty()) save_missed(outcomes, options);
  std::fflush(stdout);
}

int run_main(int argc, char** argv) {
  Options options;
  CLI::App app("Confusion matrices of the diagnosis on planted data");
  app.add_option("--sets", options.sets, "data sets of each part")->capture_default_str();
  app.add_option("--seed", options.seed)->capture_default_str();
  app.add_option("--part", options.part,
                 "single, null, pairs, unknown, alias, coverage, leakage, mounting, "
                 "few_mountings, heavy, negative, rig, dirty, law, idle, bench, apart, outliers, "
                 "imported or all")
      ->capture_default_str();
  app.add_option("--visible", options.visible,
                 "least log-likelihood ratio of the truth that counts as visible")
      ->capture_default_str();
  app.add_option("--threads", options.threads, "0: as many as the machine has");
  app.add_option("--replicates", options.diagnosis.replicates, "of the diagnosis' null model")
      ->capture_default_str();
  app.add_option(
      "--mounting-scatter", options.diagnosis.mounting_scatter,
      "told to the diagnosis, as to reeve diagnose; planted are none, but in the parts of "
      "mountings");
  app.add_flag("--list", options.list, "list what was missed");
  app.add_option("--only", options.only, "one data set, by its number in the list");
  app.add_option("--save", options.save, "folder for the data sets that were missed");
  CLI11_PARSE(app, argc, argv);
  bool found = false;
  for (const Part part : all_parts()) {
    if (options.part != "all" && options.part != part_name(part)) continue;
    found = true;
    run_part(part, options);
  }
  for (const std::string& part : foreign_parts()) {
    if (options.part != "all" && options.part != part) continue;
    found = true;
    if (!options.save.empty()) std::filesystem::create_directories(options.save);
    DiagnoseOptions diagnosis = options.diagnosis;
    diagnosis.threads = options.threads;
    fmt::print("{}", foreign_report(part, options.sets, options.seed, diagnosis, options.list,
                                    options.save));
  }
  if (!found) fmt::print(stderr, "there is no part '{}'\n", options.part);
  return found ? 0 : 2;
}

}  // namespace
}  // namespace reeve::bench

int main(int argc, char** argv) {
  try {
    return reeve::bench::run_main(argc, argv);
  } catch (const std::exception& error) {
    fmt::print(stderr, "{}\n", error.what());
    return 2;
  }
}
