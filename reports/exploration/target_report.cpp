#include "reports/exploration/target_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string>

#include "core/bars.hpp"
#include "core/notation.hpp"
#include "core/text.hpp"
#include "reports/motor_words.hpp"
#include "reports/sizing_report.hpp"

namespace reeve::reports {
namespace {

constexpr std::size_t targets_shown = 10;

// "2.00:1.00:1.00": pulls relative to the least that is wanted, so that their sum is the target's.
std::string ratio_text(const std::vector<double>& shares, const Goal& goal) {
  const double unit = *std::ranges::min_element(goal.target);
  return joined(shares, ":", [&](double share) { return fixed(share / unit, 2); });
}

std::string moved_ratio_text(const TargetedDesign& design, const Goal& goal) {
  return fmt::format("with mu -50 % {}, +50 % {}, with unlike contacts {}",
                     ratio_text(design.moved_shares.front(), goal),
                     ratio_text(design.moved_shares.back(), goal),
                     ratio_text(design.unlike.shares, goal));
}

std::string bounds_text(const SizingOptions& sizing) {
  if (sizing.varied.empty()) return "nothing varied";
  return joined(sizing.varied, ", ", [](const VariedRange& range) {
    return fmt::format("{} {:.4g} to {:.4g}", to_text(range.name), range.bounds.low,
                       range.bounds.high);
  });
}

const char* means(const TargetedDesign& design) {
  if (!design.is_met()) return "out of reach";
  return design.hangs_on_friction() ? "depends on friction" : "by statics";
}

std::string targeted_text(const TargetedDesign& design, const Goal& goal) {
  const std::string start = fmt::format("{}: {}", title_of(design.sized),
                                        ratio_text(design.sized.design.after.shares, goal));
  if (design.is_met() && !design.hangs_on_friction()) {
    return fmt::format("{} by statics; {}", start, moved_ratio_text(design, goal));
  }
  if (design.is_met()) {
    return fmt::format("{}, which depends on friction: {}", start, moved_ratio_text(design, goal));
  }
  return fmt::format("{}, shares miss by {}", start, fixed(design.sized.design.after.nominal));
}

// Bars with these arms are not among the parts that are explored.
std::vector<DocumentLine> bar_lines(const Goal& goal) {
  const auto bars = whiffletree(goal.target);
  if (!bars) return {};
  std::string arms;
  for (const Tendon& tendon : bars->tendons) {
    for (const Token& token : tendon.walk) {
      if (token.kind != TokenKind::bar_arms) continue;
      arms += fmt::format("{}{}:{} at W{}", arms.empty() ? "" : ", ", token.arms.right,
                          token.arms.left, token.block);
    }
  }
  return {{fmt::format("A whiffletree gives this ratio by statics: {}, arms {}", to_word(*bars),
                       arms)}};
}

Json targeted_json(const TargetedDesign& design, const MotorParts& motor) {
  const SizedDesign& sized = design.sized.design;
  return {{"routing", design.sized.word},
          {"name", text_or_null(design.sized.name)},
          {"met", design.is_met()},
          {"by_statics", design.is_by_statics()},
          {"hangs_on_friction", design.hangs_on_friction()},
          {"miss_without_friction", number(design.static_miss)},
          {"miss_before", number(sized.before.nominal)},
          {"miss", number(sized.after.nominal)},
          {"shares", sized.after.shares},
          {"shares_at_half_friction", design.moved_shares.front()},
          {"shares_at_one_and_a_half_friction", design.moved_shares.back()},
          {"miss_with_unlike_contacts", number(design.unlike.miss)},
          {"shares_with_unlike_contacts", design.unlike.shares},
          {"motor", motor_force_json(sized.after.motor, motor)},
          {"hardware", to_json(sized.hardware)}};
}

}  // namespace

std::vector<DocumentLine> target_lines(const std::optional<TargetReport>& report) {
  if (!report) return {};
  const Goal& goal = report->sizing.goal;
  const std::string wanted = ratio_text(goal.target, goal);
  if (report->partial) return {};
  if (report->designs.empty()) return {{"No design to meet the target " + wanted + " with", true}};
  const TargetedDesign& first = report->designs.front();
  const std::string start =
      first.is_met() ? fmt::format("Target {}: ", wanted)
                     : fmt::format("No design reaches the target {}; the nearest is ", wanted);
  std::vector<DocumentLine> lines{
      {start + targeted_text(first, goal), !first.is_met()},
      {fmt::format("Designs with this ratio by statics, without friction: {}",
                   report->by_statics)}};
  append(lines, bar_lines(goal));
  const SizedGoal& sized = first.sized.design.after;
  const MotorParts& motor = report->sizing.nominal.hardware.motor;
  for (const DocumentLine& line : motor_lines(sized.motor, motor)) {
    lines.push_back({"Sized: " + line.text, line.caveat});
  }
  return lines;
}

Section target_section(const std::optional<TargetReport>& report) {
  if (!report || report->designs.empty()) return {};
  const Goal& goal = report->sizing.goal;
  Table table{{number_column("rank"), text_column("routing"), text_column("ratio"),
               number_column("sized"), number_column("mu -50 %", "", 1),
               number_column("mu +50 %", "", 1), number_column("unlike contacts", "", 1),
               number_column("miss"), number_column("without mu"), number_column("sheaths", "", 2)},
              {}};
  const bool hand = report->designs.front().sized.design.after.motor.has_value();
  if (hand) {
    table.columns.push_back(number_column("nominal motor", "N"));
    table.columns.push_back(number_column("in 95 %", "N"));
    table.columns.push_back(number_column("stroke", "mm"));
  }
  for (std::size_t i = 0; i < std::min(targets_shown, report->designs.size()); ++i) {
    const TargetedDesign& design = report->designs[i];
    const SizedGoal& sized = design.sized.design.after;
    std::vector<std::string> cells{std::to_string(i + 1),
                                   design.sized.word,
                                   means(design),
                                   ratio_text(sized.shares, goal),
                                   ratio_text(design.moved_shares.front(), goal),
                                   ratio_text(design.moved_shares.back(), goal),
                                   ratio_text(design.unlike.shares, goal),
                                   fixed(sized.nominal),
                                   fixed(design.static_miss),
                                   fixed(value(sized.values, Objective::sheaths), 0)};
    if (hand) {
      cells.push_back(fixed(sized.motor->nominal_N, 1));
      cells.push_back(fixed(sized.motor->p95_N, 1));
      cells.push_back(fixed(value(sized.values, Objective::stroke), 1));
    }
    table.add(std::move(cells));
  }
  return {fmt::format("Nearest to the target {}, sized at the nominal coefficients: {}",
                      ratio_text(goal.target, goal), bounds_text(report->sizing)),
          table,
          {}};
}

Json target_json(const std::optional<TargetReport>& report) {
  if (!report) return nullptr;
  const MotorParts& motor = report->sizing.nominal.hardware.motor;
  return {{"target_shares", report->sizing.goal.target},
          {"grasps", to_json(goal_grasps(report->sizing))},
          {"partial", report->partial},
          {"by_statics", report->by_statics},
          {"designs", list_json(report->designs, [&](const TargetedDesign& design) {
             return targeted_json(design, motor);
           })}};
}

}  // namespace reeve::reports
