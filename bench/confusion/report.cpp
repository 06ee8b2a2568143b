#include "bench/confusion/report.hpp"

#include <boost/math/distributions/binomial.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <map>
#include <set>

namespace reeve::bench {
namespace {

using Binomial = boost::math::binomial_distribution<>;

bool is_visible(const Outcome& outcome, double visible) {
  return outcome.planted.empty() || outcome.oracle > visible;
}

// ---- the confusion matrix ----

struct Tally {
  std::size_t right = 0, among = 0, wrong = 0, abstained = 0, invisible = 0;

  void count(const Outcome& outcome, double visible) {
    if (!is_visible(outcome, visible)) {
      ++invisible;
    } else if (as_it_should_be(outcome)) {
      ++right;
    } else if (names_among_others(outcome)) {
      ++among;
    } else if (names_wrong(outcome, outcome.finding)) {
      ++wrong;
    } else {
      ++abstained;
    }
  }
};

std::string text(const Tally& tally) {
  const std::string visible =
      fmt::format("{}/{}/{}/{}", tally.right, tally.among, tally.wrong, tally.abstained);
  return tally.invisible == 0 ? visible : visible + fmt::format(" ({})", tally.invisible);
}

// Pairs are too many kinds for a table of kinds.
std::string row_of(const Outcome& outcome) {
  return outcome.trial.part == Part::pairs ? "two causes" : outcome.trial.kind();
}

std::string matrix(const std::vector<Outcome>& outcomes, double visible) {
  std::vector<std::string> rows, columns;
  std::map<std::pair<std::string, std::string>, Tally> tallies;
  const auto add = [](std::vector<std::string>& names, const std::string& name) {
    if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
  };
  for (const Outcome& outcome : outcomes) {
    add(rows, row_of(outcome));
    add(columns, outcome.trial.column());
    tallies[{row_of(outcome), outcome.trial.column()}].count(outcome, visible);
  }
  std::sort(columns.begin(), columns.end());
  std::string out = "| planted | " + fmt::format("{}", fmt::join(columns, " | ")) + " |\n| --- |";
  for (std::size_t i = 0; i < columns.size(); ++i) out += " --- |";
  for (const std::string& row : rows) {
    out += "\n| " + row + " |";
    for (const std::string& column : columns) out += " " + text(tallies[{row, column}]) + " |";
  }
  return out + "\n\n";
}

// ---- rates ----

Rate rate(const std::vector<const Outcome*>& outcomes,
          const std::function<bool(const Outcome&)>& hit) {
  Rate rate;
  for (const Outcome* outcome : outcomes) rate.count(hit(*outcome));
  return rate;
}

std::string plain(const std::string& what, const Rate& rate) {
  if (rate.of == 0) return fmt::format("- {}: nothing to count", what);
  return fmt::format("- {}: {:.1f} % ({} of {}; 95 % interval {:.1f} to {:.1f} %)", what,
                     100 * rate.share(), rate.hits, rate.of, 100 * rate.low(), 100 * rate.high());
}

std::string required(const std::string& what, const Rate& rate, const std::string& requirement,
                     bool met) {
  if (rate.of == 0) return plain(what, rate) + "\n";
  return fmt::format("{}; required {}: {}\n", plain(what, rate), requirement,
                     met ? "met" : "NOT MET");
}

std::string at_least(const std::string& what, const Rate& rate, double percent) {
  return required(what, rate, fmt::format("at least {} %", percent), 100 * rate.share() >= percent);
}

std::string at_most(const std::string& what, const Rate& rate, double percent) {
  return required(what, rate, fmt::format("at most {} %", percent), 100 * rate.share() <= percent);
}

// Named, or among the few that the data cannot tell apart and are said to be so.
bool right_or_among(const Outcome& outcome) {
  return as_it_should_be(outcome) || names_among_others(outcome);
}

// By all readings, with the noise as it was planted: of two causes that were as likely before they
// were taken, the other one would then be hidden in 2 % of such data sets.
constexpr double least_margin = 3.9;

std::string named_right(const std::vector<const Outcome*>& seen, const std::string& what,
                        double percent, double visible) {
  std::vector<const Outcome*> separable;
  for (const Outcome* outcome : seen) {
    const auto& found = outcome->separability;
    if (found && found->margin > least_margin && found->over_none > visible) {
      separable.push_back(outcome);
    }
  }
  return at_least(what, rate(seen, as_it_should_be), percent) +
         at_least(
             what + ", of those that the readings can tell from every other cause and from none",
             rate(separable, as_it_should_be), percent) +
         plain(what + ", or among those that cannot be told apart", rate(seen, right_or_among)) +
         "\n";
}

bool wrong(const Outcome& outcome) { return names_wrong(outcome, outcome.finding); }

// True if something is named for what the library does not hold, beside laws that say it: drift and
// wave change the gain of all channels from row to row, and no law says what crosstalk does.
bool misnames(const Outcome& outcome) {
  const bool is_a_law = outcome.planted != std::vector<std::string>{"crosstalk"};
  const auto is_right = [](const std::string& name) {
    return name.starts_with("law[gain of all channels, order, ");
  };
  return std::any_of(
      outcome.finding.named.begin(), outcome.finding.named.end(), [&](const std::string& name) {
        const auto equivalent = said_equivalent(outcome.finding, name);
        return !is_a_law || std::none_of(equivalent.begin(), equivalent.end(), is_right);
      });
}

std::string verdicts(const std::vector<const Outcome*>& outcomes) {
  std::map<std::string, std::size_t> counts;
  for (const Outcome* outcome : outcomes) ++counts[verdict_name(outcome->finding.verdict)];
  std::string out = "- verdicts:";
  for (const auto& [verdict, count] : counts) out += fmt::format(" {} {},", verdict, count);
  out.back() = '\n';
  return out;
}

std::string coverage(const std::vector<const Outcome*>& outcomes) {
  Rate all;
  std::map<std::string, Rate> by_parameter;
  for (const Outcome* outcome : outcomes) {
    for (const FoundInterval& interval : outcome->intervals) {
      all.count(interval.covers());
      by_parameter[interval.parameter].count(interval.covers());
    }
  }
  // Few intervals that are all right are no sign that they are too wide.
  std::string out = required("true value within the interval", all, "90 to 98 %",
                             all.share() >= 0.9 && (all.of == 0 || all.low() <= 0.98));
  for (const auto& [parameter, covered] : by_parameter) {
    out += fmt::format("  - {}: {} of {}\n", parameter, covered.hits, covered.of);
  }
  return out;
}

std::string gains(const std::vector<const Outcome*>& outcomes) {
  Rate reached;
  double found = 0, possible = 0;
  for (const Outcome* outcome : outcomes) {
    if (!outcome->gain) continue;
    found += outcome->gain->found;
    possible += outcome->gain->possible;
    reached.count(outcome->gain->found >= 0.9 * outcome->gain->possible);
  }
  if (reached.of == 0) return "- held-out gain: nothing to count\n";
  return fmt::format(
      "- held-out gain, reduction of the rms residual over that of the truth: {:.1f} % of {:.3f} on "
      "average; 90 % of it is reached in {} of {} sets; required at least 90 %: {}\n",
      100 * found / possible, possible / static_cast<double>(reached.of), reached.hits, reached.of,
      found >= 0.9 * possible ? "met" : "NOT MET");
}

// In one group of causes that explain the data alike.
bool reports_both(const Outcome& outcome) {
  if (outcome.finding.verdict != Verdict::indistinguishable) return false;
  const auto& groups = outcome.finding.indistinguishable;
  return std::any_of(groups.begin(), groups.end(), [&](const std::vector<std::string>& group) {
    const std::set<std::string> names(group.begin(), group.end());
    return std::all_of(outcome.equivalent.begin(), outcome.equivalent.end(),
                       [&](const std::string& equivalent) { return names.contains(equivalent); });
  });
}

bool resolves(const Outcome& outcome) {
  return outcome.with_more && names_all(outcome, *outcome.with_more);
}

bool same_without_dirt(const Outcome& outcome) {
  return outcome.with_more && outcome.with_more->verdict == outcome.finding.verdict &&
         outcome.with_more->named == outcome.finding.named;
}

// Some of them hide a cause, others none.
std::string of_hard_readings(const std::vector<const Outcome*>& seen, double visible) {
  std::vector<const Outcome*> hidden, calm;
  for (const Outcome* outcome : seen) {
    (outcome->planted.empty() ? calm : hidden).push_back(outcome);
  }
  return named_right(hidden, "named right", 95, visible) +
         at_most("named wrong", rate(hidden, wrong), 2) +
         at_most("a cause named where none is hidden", rate(calm, wrong), 5) +
         plain("any verdict but none where none is hidden",
               rate(calm, [](const Outcome& o) { return o.finding.verdict != Verdict::none; })) +
         "\n" + coverage(seen) + gains(hidden);
}

std::string rates(Part part, const std::vector<const Outcome*>& seen, double visible) {
  switch (part) {
    case Part::single:
    case Part::rig:
      return named_right(seen, "named right", 95, visible) +
             at_most("named wrong", rate(seen, wrong), 2) + coverage(seen) + gains(seen);
    case Part::coverage:
      return coverage(seen) + gains(seen);
    case Part::null:
      return at_most("a cause named where none is hidden", rate(seen, wrong), 5) +
             plain(
                 "any verdict but none",
                 rate(seen, [](const Outcome& o) { return o.finding.verdict != Verdict::none; })) +
             "\n";
    case Part::pairs:
      return named_right(seen, "both named", 85, visible) +
             plain("something wrong named", rate(seen, wrong)) + "\n" + coverage(seen) +
             gains(seen);
    case Part::unknown:
      return at_least("unexplained, or the law that says it", rate(seen, as_it_should_be), 90) +
             plain("something else named", rate(seen, misnames)) + "\n";
    case Part::alias:
      return at_least("indistinguishable, with both names", rate(seen, reports_both), 95) +
             at_least("resolved with the further runs", rate(seen, resolves), 95);
    case Part::mounting:
    case Part::few_mountings:
    case Part::heavy:
    case Part::negative:
      return of_hard_readings(seen, visible);
    case Part::dirty:
      return at_least("the same verdict and names as of the clean file",
                      rate(seen, same_without_dirt), 95);
    case Part::leakage:
      return at_least("all copied rows dropped",
                      rate(seen, [](const Outcome& o) { return o.copies_dropped.value(); }), 100) +
             at_least("the same verdict as without copies", rate(seen, same_without_dirt), 100);
  }
  return "";
}

std::string found_text(const Finding& finding) {
  std::string out =
      fmt::format("{}: {}", verdict_name(finding.verdict), fmt::join(finding.named, ", "));
  for (const auto& group : finding.indistinguishable) {
    out += fmt::format(" [{}]", fmt::join(group, " ~ "));
  }
  if (!finding.given_up.empty()) {
    out += fmt::format(" (given up: {})", fmt::join(finding.given_up, ", "));
  }
  return out;
}

}  // namespace

double Rate::share() const {
  return of == 0 ? 0 : static_cast<double>(hits) / static_cast<double>(of);
}

double Rate::low() const {
  return Binomial::find_lower_bound_on_p(static_cast<double>(of), static_cast<double>(hits), 0.025);
}

double Rate::high() const {
  return Binomial::find_upper_bound_on_p(static_cast<double>(of), static_cast<double>(hits), 0.025);
}

bool as_it_should_be(const Outcome& outcome) {
  const Finding& finding = outcome.finding;
  switch (outcome.trial.part) {
    case Part::unknown:
      return finding.verdict == Verdict::unexplained ||
             (!finding.named.empty() && !misnames(outcome));
    case Part::alias:
      return reports_both(outcome);
    case Part::dirty:
      return same_without_dirt(outcome);
    case Part::leakage:
      return outcome.copies_dropped.value_or(false) && same_without_dirt(outcome);
    default:
      return outcome.planted.empty() ? finding.verdict == Verdict::none
                                     : names_all(outcome, finding);
  }
}

std::string report(Part part, const std::vector<Outcome>& outcomes, double visible) {
  std::vector<const Outcome*> seen;
  for (const Outcome& outcome : outcomes) {
    if (is_visible(outcome, visible)) seen.push_back(&outcome);
  }
  return fmt::format(
             "## {}\n\n{} data sets, {} with a visible effect (log-likelihood ratio of the truth "
             "above {}). Right/right among others that cannot be told apart/wrong/abstained (invisible):"
             "\n\n",
             part_name(part), outcomes.size(), seen.size(), visible) +
         matrix(outcomes, visible) + rates(part, seen, visible) + verdicts(seen) + "\n";
}

std::string misses(const std::vector<Outcome>& outcomes, double visible) {
  std::string out;
  for (const Outcome& outcome : outcomes) {
    const bool stays_open = outcome.trial.part == Part::alias && !resolves(outcome);
    if ((as_it_should_be(outcome) && !stays_open) || !is_visible(outcome, visible)) continue;
    out += fmt::format("- {} {} ({}), ratio {:.0f}: {} -> {}", part_name(outcome.trial.part),
                       outcome.trial.seed, outcome.trial.column(), outcome.oracle,
                       fmt::join(outcome.planted, " + "), found_text(outcome.finding));
    if (outcome.separability) {
      out +=
          fmt::format("; {} less likely by {:.1f}, none by {:.1f}", outcome.separability->nearest,
                      outcome.separability->margin, outcome.separability->over_none);
    }
    if (outcome.with_more) out += "; then " + found_text(*outcome.with_more);
    out += "\n";
  }
  return out;
}

}  // namespace reeve::bench
