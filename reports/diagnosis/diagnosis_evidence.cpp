#include "reports/diagnosis/diagnosis_evidence.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>
#include <utility>

#include "core/text.hpp"
#include "reports/data_text.hpp"
#include "reports/diagnosis/diagnosis_words.hpp"

namespace reeve::reports {
namespace {

const PublishedLine* line_of(const PublishedModel& model, std::size_t group) {
  const auto found = std::ranges::find(model.lines, group, &PublishedLine::group);
  return found == model.lines.end() ? nullptr : &*found;
}

std::string published_heading(const PublishedModel& model) {
  return fmt::format("{}, mu {:g}", model.name, model.mu);
}

std::string factor(double loss) { return fixed(std::exp(-loss), 3); }

std::string stretch_text(const DiagnosisReport& report, const Loss& loss) {
  return fmt::format("{}, {} to {}", routing_name(report, loss.routing), segment_name(loss.high),
                     segment_name(loss.low));
}

// On a bench no grasp is worth a column.
void leave_out_grasps(const DiagnosisReport& report, Table& table) {
  if (!is_bench(report.data)) return;
  const auto held = std::ranges::find_if(
      table.columns, [](const TableColumn& column) { return column.heading == "held"; });
  const auto at = held - table.columns.begin();
  table.columns.erase(held);
  for (TableRow& row : table.rows) row.cells.erase(row.cells.begin() + at);
}

const NamedCause* find_cause(const DiagnosisReport& report, std::string_view name) {
  const auto found = std::ranges::find(report.result.causes, name, &NamedCause::name);
  return found == report.result.causes.end() ? nullptr : &*found;
}

}  // namespace

std::string contacts_text(const std::vector<ContactKind>& contacts) {
  return joined(contacts, ", ", contact_kind_name);
}

Table share_error_table(const DiagnosisReport& report) {
  const ShareErrors& errors = report.result.share_errors;
  const bool left_out = errors.left_out.has_value();
  const bool extended = !report.result.model.effects.empty();
  Table table{{text_column("routing"), text_column("held"), number_column("readings"),
               number_column("held out"), number_column("nominal")},
              {}};
  if (extended) table.columns.push_back(number_column("extended"));
  if (left_out) table.columns.push_back(number_column("fitted without it"));
  for (const PublishedModel& model : report.published) {
    table.columns.push_back(number_column(published_heading(model)));
  }
  for (std::size_t g = 0; g < errors.groups.size(); ++g) {
    const ShareError& group = errors.groups[g];
    std::vector<std::string> cells{routing_name(report, group.routing), to_text(group.grasp),
                                   std::to_string(group.rows), std::to_string(group.held_out_rows),
                                   percent(group.before)};
    if (extended) cells.push_back(percent(group.after));
    if (left_out) cells.push_back(percent(*group.left_out));
    for (const PublishedModel& model : report.published) {
      const PublishedLine* line = line_of(model, g);
      cells.push_back(line == nullptr ? "-" : percent(line->error));
    }
    table.add(std::move(cells));
  }
  if (errors.groups.size() > 1) {
    std::vector<std::string> cells{"mean", "", "", "", percent(errors.before)};
    if (extended) cells.push_back(percent(errors.after));
    if (left_out) cells.push_back(percent(*errors.left_out));
    for (const PublishedModel& model : report.published) cells.push_back(percent(model.error));
    table.add(std::move(cells));
  }
  leave_out_grasps(report, table);
  return table;
}

void add_gains(const DiagnosisResult& result, Table& gains) {
  const auto add = [&](const std::string& name, const HeldOut& held_out) {
    gains.add({name, newton(held_out.rms_before_N), newton(held_out.rms_after_N),
               percent_text(held_out.reduction),
               percent_text(held_out.low) + " to " + percent_text(held_out.high),
               gain_number(held_out.log_likelihood_gain),
               gain_interval(held_out.gain_low, held_out.gain_high),
               gain_number(held_out.expected_gain)});
  };
  for (const NamedCause& cause : result.causes) {
    if (cause.held_out) add(cause.name, *cause.held_out);
  }
  if (result.held_out && result.causes.size() > 1) add("all together", *result.held_out);
}

Table structure_table(const DiagnosisReport& report, std::size_t most) {
  Table table{{text_column("residuals follow"), number_column("size"),
               number_column("deviations from chance"), number_column("p of this alone")},
              {}};
  const std::vector<StructureFinding>& findings = report.result.structure;
  for (std::size_t i = 0; i < std::min(most, findings.size()); ++i) {
    const StructureFinding& finding = findings[i];
    table.add({pattern_text(report, finding.about),
               part_of_residuals(report, structure_N(report, finding)), fixed(finding.statistic, 1),
               p_number(finding.p_value, report.settings.replicates)});
  }
  return table;
}

Table loss_table(const DiagnosisReport& report) {
  const bool extended = !report.result.model.effects.empty();
  Table table{
      {text_column("routing"), text_column("held"), text_column("direction"), text_column("from"),
       text_column("to"), text_column("over"), number_column("readings", "", 2),
       number_column("measured"), number_column("nominal")},
      {}};
  if (extended) table.columns.push_back(number_column("extended"));
  table.columns.push_back(text_column("remark"));
  for (const Loss& loss : report.result.losses) {
    std::vector<std::string> cells{routing_name(report, loss.routing),
                                   to_text(loss.grasp),
                                   direction_field(loss.direction),
                                   segment_name(loss.high),
                                   segment_name(loss.low),
                                   contacts_text(loss.over),
                                   std::to_string(loss.rows),
                                   factor(loss.measured),
                                   factor(loss.before)};
    if (extended) cells.push_back(factor(loss.after));
    cells.push_back(loss.stands_apart ? "stands apart" : "");
    table.add(std::move(cells), loss.stands_apart ? Tint::notable : Tint::none);
  }
  leave_out_grasps(report, table);
  return table;
}

std::vector<std::string> loss_sentences(const DiagnosisReport& report) {
  std::vector<std::string> sentences;
  for (const Loss& loss : report.result.losses) {
    if (!loss.stands_apart) continue;
    double least = std::numeric_limits<double>::infinity();
    double most = 0;
    for (const Loss& other : report.result.losses) {
      if (&other == &loss || other.over != loss.over) continue;
      least = std::min(least, std::exp(-other.measured));
      most = std::max(most, std::exp(-other.measured));
    }
    std::string text = fmt::format(
        "{}: {} of the tension is left, where {} has {}", stretch_text(report, loss),
        factor(loss.measured),
        report.result.model.effects.empty() ? "the nominal model" : "the extended model",
        factor(loss.after));
    if (most > 0) {
      text += fmt::format(" and other stretches over {} read {} to {}", contacts_text(loss.over),
                          fixed(least, 2), fixed(most, 2));
    }
    sentences.push_back(text + ": this contact, or this reading, is not like the others.");
  }
  return sentences;
}

namespace {

// "T4 of TR1 (line 9)", "T2 of TR2, held 1 (238 readings)": in the order of the first of each.
std::vector<std::string> places_text(const DiagnosisReport& report,
                                     const std::vector<Cell>& cells) {
  using Place = std::tuple<std::size_t, std::size_t, std::uint64_t, Direction>;
  std::vector<std::pair<Place, std::vector<Cell>>> places;
  for (const Cell& cell : cells) {
    const Reading& reading = report.data.readings[cell.reading];
    const Place place{cell.channel, reading.routing, reading.grasp.held, reading.direction};
    auto found =
        std::ranges::find_if(places, [&](const auto& known) { return known.first == place; });
    if (found == places.end()) found = places.insert(found, {place, {}});
    found->second.push_back(cell);
  }
  std::vector<std::string> texts;
  for (const auto& [place, of] : places) {
    const Reading& reading = report.data.readings[of.front().reading];
    const std::string what = fmt::format("{} of {}", report.data.channels[of.front().channel].name,
                                         routing_name(report, reading.routing));
    const std::string circumstances =
        (is_bench(report.data) ? "" : ", held " + to_text(reading.grasp)) +
        (reading.direction == Direction::pull ? "" : ", release");
    texts.push_back(of.size() == 1
                        ? fmt::format("{} (line {})", what, reading.line)
                        : fmt::format("{}{} ({} readings)", what, circumstances, of.size()));
  }
  return texts;
}

std::string refitted_text(const WithoutApart& without, const NamedCause& cause) {
  for (std::size_t e = 0; e < without.model.effects.size(); ++e) {
    if (effect_name(without.model.effects[e]) != cause.name) continue;
    NamedCause refitted = cause;
    for (std::size_t p = 0; p < refitted.parameters.size(); ++p) {
      EstimatedParameter& parameter = refitted.parameters[p];
      parameter.value = without.model.effects[e].values[p];
      parameter.low = without.intervals[e][p].low;
      parameter.high = without.intervals[e][p].high;
    }
    return size_with_interval(refitted);
  }
  return "";
}

}  // namespace

std::vector<std::string> without_apart_sentences(const DiagnosisReport& report) {
  constexpr std::size_t most_named = 4;
  if (!report.result.without_apart) return {};
  const WithoutApart& without = *report.result.without_apart;
  std::vector<std::string> sizes;
  for (const NamedCause& cause : report.result.causes) {
    std::string size = refitted_text(without, cause);
    if (!size.empty()) sizes.push_back(std::move(size));
  }
  std::string text = fmt::format(
      "Fitted to all readings but {}: {}",
      enumerated(places_text(report, without.left_out), ", ", most_named), fmt::join(sizes, "; "));
  if (without.share_error) {
    text += fmt::format("; the tension distribution is then off by {} on average",
                        percent(*without.share_error));
  }
  return {text + "."};
}

std::vector<std::string> influence_sentences(const DiagnosisReport& report) {
  std::vector<std::string> sentences;
  for (const NamedCause& cause : report.result.causes) {
    for (std::size_t p = 0; p < cause.parameters.size(); ++p) {
      const EstimatedParameter& parameter = cause.parameters[p];
      const LeftOutRun* farthest = nullptr;
      double low = 0, high = 0, moved = 0;
      for (const LeftOutRun& run : report.result.left_out) {
        double value = parameter.value;
        for (const Effect& effect : run.model.effects) {
          if (effect_name(effect) == cause.name) value = effect.values[p];
        }
        low = farthest == nullptr ? value : std::min(low, value);
        high = farthest == nullptr ? value : std::max(high, value);
        const double by = std::abs(value - parameter.value);
        if (farthest == nullptr || by > moved) {
          farthest = &run;
          moved = by;
        }
      }
      if (farthest == nullptr) continue;
      sentences.push_back(fmt::format(
          "With any one run left out and the others fitted, {} of {} lies between {} and {}; run {} "
          "moves it farthest.",
          parameter.name, cause.name, estimate(parameter, low), estimate(parameter, high),
          report.data.runs[farthest->run]));
    }
  }
  return sentences;
}

std::vector<std::string> published_sentences(const DiagnosisReport& report) {
  std::vector<std::string> sentences;
  const NamedCause* sheath = find_cause(report, "sheath_friction");
  for (const PublishedModel& model : report.published) {
    sentences.push_back(fmt::format(
        "The published lines ({}, mu = {:g}) have a mean error of {}, the equations with that "
        "coefficient one of {}.",
        model.name, model.mu, percent(model.error), percent(model.equations)));
    for (const PublishedLoss& other : model.losses) {
      const Loss& loss = report.result.losses[other.loss];
      if (other.sheaths_drawn == other.sheaths) continue;
      std::string text = fmt::format(
          "{}, ln of the ratio: printed line {:.2f} ({}), equations {:.2f} ({}), measured {:.2f}",
          stretch_text(report, loss), other.printed,
          plural(static_cast<std::size_t>(other.sheaths_drawn), "sheath"), other.equations,
          plural(static_cast<std::size_t>(other.sheaths), "sheath"), loss.measured);
      if (sheath != nullptr) {
        const double rig = sheath->parameters.front().value;
        text += fmt::format("; {} sheaths of mu = {} add up to {:.3f}, and {} of {:g} to {:g}",
                            other.sheaths, estimate(sheath->parameters.front(), rig),
                            other.sheaths * rig, other.sheaths_drawn, model.mu,
                            other.sheaths_drawn * model.mu);
      }
      sentences.push_back(text + ".");
    }
  }
  return sentences;
}

}  // namespace reeve::reports
