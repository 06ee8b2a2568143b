#include "cli/flags/generator_flags.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "cli/inputs.hpp"
#include "reports/exploration/part_words.hpp"

namespace reeve::cli {

void GeneratorFlags::add_to(CLI::App& command, bool with_tendons) {
  add_with_default(command, "--fingers", fingers, "Number of fingers")
      ->check(CLI::Range(1, max_fingers));
  parts_ = add_with_default(command, "--parts", parts,
                            "Set of parts; all: full, --anchored and --blocks 1; field: all with "
                            "more blocks")
               ->check(one_of({"paper", "full", "all", "field"}));
  tips.add(command, "--tips", "Kinds of fingertips in place of the set's: tube,bearing");
  joins.add(command, "--joins", "Kinds of joins in place of the set's: T,B,P");
  ends.add(command, "--ends", "Kinds of ends in place of the set's: M,F");
  command.add_flag("--anchored", anchored,
                   "Also tendons that are tied at a fingertip, such as M-1x");
  blocks_ =
      command
          .add_option("--blocks", blocks,
                      "Most floating blocks, as in M-Y1+1x-Y1-2x; may cost anchored tips (default: "
                      "that of --parts)")
          ->check(CLI::Range(0, max_generated_blocks));
  command.add_option("--beside-ends", beside,
                     "Joins that may stand beside an end or a block's tail, such as P in F-P-1x");
  command.add_flag("--linked", switches.linked,
                   "Also blocks tied tail to tail, such as Y1-Y2+1x-Y1-2x+M-Y2-3x");
  command.add_flag("--series", switches.series,
                   "Also blocks in series on one tendon, such as M-Y1-Y2-M+Y1-1x+Y2-2x");
  command.add_flag("--bars", switches.bars,
                   "Also rigid bars in place of blocks, such as M-W1+1x-W1/1:2-Y1+2x-Y1-3x");
  command.add_flag("--beckets", switches.beckets,
                   "Also tendons tied to the block that they pass, such as M-Y1+Y1k-1-Y1-2x");
  command.add_flag("--double-passes", switches.double_passes,
                   "Also tendons that pass their block twice, such as M-Y1+1x-Y1-2-Y1-3x");
  add_with_default(command, "--motors", motors,
                   "Number of motors, each of which pulls a tendon, such as 2 in M-1-M2")
      ->check(CLI::Range(1, max_carriages));
  command.add_flag("--distinct-fingers", distinct,
                   "Tell fingers, and motors, apart: M-1-P-2-F and M-2-P-1-F are two routings");
  if (!with_tendons) return;
  add_with_default(command, "--tendons", tendons,
                   "Number of tendons; those that blocks join to a tree count as one")
      ->check(one_of({"one", "any"}));
}

GeneratorOptions GeneratorFlags::read_parts() const {
  GeneratorOptions options;
  options.parts = parts == "paper" ? paper_parts() : parts == "all" ? all_parts() : full_parts();
  options.parts.motors = motors;
  if (anchored) options.parts.anchored = true;
  for (const PartSwitch& part : part_switches) options.parts.*part.is_in = switches.*part.is_in;
  if (blocks_->count() > 0) options.parts.blocks = blocks;
  for_name("--", [&] {
    if (tips.is_given()) options.parts.tips = parse_tips(tips.text);
    if (joins.is_given()) options.parts.joins = parse_joins(joins.text);
    if (ends.is_given()) options.parts.ends = parse_ends(ends.text);
    options.parts.beside = parse_joins(beside, "beside-ends");
    validate(options.parts);
  });
  return options;
}

namespace {

// Without these blocks a routing has none of what such a switch asks for. `from` says what their
// number comes from.
void require_blocks(const PartSet& parts, const std::string& from) {
  for (const PartSwitch& part : part_switches) {
    if (!(parts.*part.is_in) || parts.blocks >= part.least_blocks) continue;
    std::string option = std::string("--") + part.name;
    std::ranges::replace(option, '_', '-');
    throw InputError({.what = fmt::format("{} with {}", option, from),
                      .expected = fmt::format("--blocks {} at least", part.least_blocks)});
  }
}

}  // namespace

AskedParts GeneratorFlags::read(bool tells_apart) const {
  AskedParts asked = read_whole(tells_apart);
  const int greatest = asked.generator.parts.blocks;
  require_blocks(
      asked.generator.parts,
      blocks_->count() > 0
          ? fmt::format("--blocks {}", greatest)
          : fmt::format("--parts {}{}, which has {} floating block{}", parts,
                        parts_->count() > 0 ? "" : " (the default)",
                        greatest == 0 ? "no" : std::to_string(greatest), greatest == 1 ? "" : "s"));
  return asked;
}

AskedParts GeneratorFlags::read_whole(bool tells_apart) const {
  AskedParts asked{read_parts(), std::nullopt};
  asked.generator.fingers = fingers;
  asked.generator.identity =
      distinct || tells_apart ? FingerIdentity::distinct : FingerIdentity::identical;
  asked.generator.one_tendon = tendons == "one";
  if (parts != "field") return asked;
  FieldRequest request{asked.generator, std::nullopt};
  if (blocks_->count() > 0) request.blocks = blocks;
  FieldParts field =
      for_option(fmt::format("--fingers {}", fingers), [&] { return field_parts(request); });
  asked.generator.parts = std::move(field.parts);
  asked.left_out = field.left_out;
  return asked;
}

}  // namespace reeve::cli
