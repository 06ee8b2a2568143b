#include "cli/flags/size_flags.hpp"

#include "cli/printing.hpp"

namespace reeve::cli {
namespace {

void add_goal(CLI::App& command, SizeFlags& flags) {
  CLI::Option* goal =
      command
          .add_option("--goal", flags.goal,
                      "What to make the most of: an objective, or a product such as "
                      "uniformity_worst*efficiency_worst; score: that of --score")
          ->capture_default_str();
  flags.target_given =
      command
          .add_option("--target", flags.target,
                      "Instead: how hard the fingers are to pull, relative to each other, such as "
                      "1=2,others=1")
          ->excludes(goal);
  flags.score_given =
      command.add_option("--score", flags.score, "For --goal score: objectives with weights")
          ->default_str("authors");
  flags.grasps_given = command
                           .add_option("--grasps", flags.grasps,
                                       "As of rank; with --target none held, unless they are given")
                           ->capture_default_str();
}

void add_search(CLI::App& command, SizeFlags& flags) {
  SizingOptions& search = flags.search;
  CLI::Option* nominal = command.add_flag(
      "--nominal", flags.nominal,
      "Size for the coefficients as they are, and not for the 5 % quantile over their ranges");
  command.add_option("--draws", search.draws, "Draws of the coefficients")
      ->excludes(nominal)
      ->check(CLI::Range(std::size_t{1}, std::size_t{10000}))
      ->capture_default_str();
  command.add_option("--seed", search.seed, "Seed of the draws and of the starts")
      ->check(is_seed)
      ->capture_default_str();
  command.add_option("--starts", search.starts, "Local searches, besides the global one")
      ->check(CLI::Range(1, 1000))
      ->capture_default_str();
  command.add_option("--evaluations", search.evaluations, "At most, of each search")
      ->check(CLI::Range(10, 1000000))
      ->capture_default_str();
  command
      .add_option("--threads", search.threads, "Threads; 0: all. The result does not depend on it")
      ->check(CLI::Range(0, 1024))
      ->capture_default_str();
}

}  // namespace

void SizeFlags::add_to(CLI::App& command) {
  command.add_option("routing", routings, "Catalogue names or words");
  from_given =
      command.add_option("--from", from, "Folder of an exploration: also the best of its designs");
  command.add_option("--top", top, "For --from: how many of them")
      ->check(CLI::Range(std::size_t{1}, std::size_t{1000}))
      ->needs(from_given)
      ->capture_default_str();
  command
      .add_option(
          "--vary", vary,
          "A dimension and its bounds, such as 'sheath_angle[1]=3..9'; sheath_angle=3..9: "
          "of all fingers, each by itself. Also tip_angle, strand_mm, closing, "
          "arm_mm, contact_angle[T2-T3], motor_side_mm, hand_mm. May be given several times")
      ->allow_extra_args(false);
  command
      .add_option("--same", same,
                  "What stays equal: tips, sheaths, strands, arms, or dimensions such as "
                  "'sheath_angle[2,3,4]'. May be given several times")
      ->allow_extra_args(false);
  add_goal(command, *this);
  add_search(command, *this);
  save_given = command.add_option("--save-hardware", save,
                                  "Write the hardware, as it is sized, as a TOML file");
  out.add_to(command, "a page, index.html, with sizing.json and figures/");
  model.add_to(command);
  tables.add_to(command, "the dimensions, or of the routings sized");
  format.add_to(command, with_tables({"json"}));
}

}  // namespace reeve::cli
