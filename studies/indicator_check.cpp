#include "studies/indicator_check.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <numbers>
#include <numeric>
#include <optional>

#include "catalog/solution.hpp"
#include "core/error.hpp"
#include "core/indicators.hpp"
#include "readings/measured_shares.hpp"

namespace reeve::studies {
namespace {

// Mean over standard deviation of a folded normal distribution about 0.
const double greatest_gap = std::sqrt(2 / (std::numbers::pi - 2));
constexpr std::size_t concave_indicators = 3;  // the first three
constexpr std::size_t transmission = 4;

using Five = std::array<double, indicator_count>;

double sum(const std::vector<double>& values) {
  return std::accumulate(values.begin(), values.end(), 0.0);
}

double mean(const Five& five) { return std::accumulate(five.begin(), five.end(), 0.0) / 5; }

// The network's tensions as read, those at the motor by the rules, at T_M = 1.
Five indicators_of(const CatalogueEntry& entry, const std::vector<double>& strands, double ratio,
                   const std::vector<MotorSideRule>& rules) {
  const Network network = expand(entry.routing);
  TensionState state;
  double motor = 0;
  for (const Segment& segment : network.segments) {
    const auto number = static_cast<std::size_t>(segment.number - 1);
    if (segment.kind == SegmentKind::strand) {
      state.tension.push_back(strands[number]);
      continue;
    }
    const double strand = strands[static_cast<std::size_t>(rules[number].strand - 1)];
    state.tension.push_back(rules[number].to_motor ? strand / ratio : strand * ratio);
    motor += state.tension.back();
  }
  for (double& tension : state.tension) tension /= motor;
  const Indicators found = indicators(network, state);
  return {found.adaptability, found.torsional_balance, found.reliability, found.authors_efficiency,
          found.transmission};
}

struct RowCheck {
  const CatalogueEntry* entry = nullptr;
  const IndicatorRow* row = nullptr;
  std::vector<double> strands;
  Five computed{};
  Five tolerance{};

  double low(std::size_t i) const {
    const double gap = i < concave_indicators ? greatest_gap * row->deviation[i] : 0;
    return computed[i] - tolerance[i] - gap;
  }
  double high(std::size_t i) const { return computed[i] + tolerance[i]; }
};

bool fits(const PrintedNumber& printed, double low, double high) {
  return printed.value >= low - printed.half_unit && printed.value <= high + printed.half_unit;
}

bool fits(const PrintedNumber& printed, const RowCheck& check, std::size_t i) {
  return fits(printed, check.low(i), check.high(i));
}

bool mean_fits(const PrintedNumber& printed, const RowCheck& check) {
  double low = 0;
  double high = 0;
  for (std::size_t i = 0; i < indicator_count; ++i) {
    low += check.low(i) / indicator_count;
    high += check.high(i) / indicator_count;
  }
  return fits(printed, low, high);
}

// The rules say how the sheaths slide; the solver derives it.
void require_sheaths_that_slide_so(const Publication& publication, const CatalogueEntry& entry,
                                   const IndicatorRow& row) {
  const Solution solution = solve(entry);
  const auto refuse = [&](const std::string& what) {
    throw InputError({.where = fmt::format("{}: indicators.row of {}: motor_side", publication.file,
                                           row.routing),
                      .what = what});
  };
  if (row.motor_side.size() != solution.sheaths.size()) {
    refuse(fmt::format("expected {} segments, one for each sheath", solution.sheaths.size()));
  }
  for (const MotorSideRule& rule : row.motor_side) {
    const bool found = std::ranges::any_of(solution.sheaths, [&](const SheathEnds& sheath) {
      return rule == MotorSideRule{static_cast<int>(sheath.strand) + 1, sheath.ratio >= 1};
    });
    if (!found) {
      refuse(fmt::format("no sheath slides to the {} at strand {}",
                         rule.to_motor ? "motor" : "hand", rule.strand));
    }
  }
}

class IndicatorCheck {
 public:
  IndicatorCheck(const Catalogue& catalogue, const Publication& publication,
                 const MeasuredData& readings)
      : publication_(publication),
        table_(*publication.indicators),
        ratio_(implied_ratio(catalogue, publication, readings)),
        fault_holds_(table_.faults.size(), false) {
    for (const IndicatorRow& row : table_.rows) {
      const CatalogueEntry& entry = entry_of(catalogue, publication, row.routing);
      require_sheaths_that_slide_so(publication, entry, row);
      rows_.push_back(
          checked(entry, row, strand_readings(publication, entry, readings), row.motor_side));
    }
  }

  std::vector<CheckItem> run() {
    for (const RowCheck& row : rows_) {
      for (std::size_t i = 0; i < indicator_count; ++i) {
        const PrintedNumber& printed = row.row->printed[i];
        add(
            row, printed, {CheckedKind::indicator, static_cast<int>(i + 1)},
            [&](const RowCheck& other) { return fits(printed, other, i); },
            [&](const RowCheck& other) { return other.computed[i]; });
      }
      const PrintedNumber& printed = row.row->mean;
      add(
          row, printed, {CheckedKind::indicator_mean, 0},
          [&](const RowCheck& other) { return mean_fits(printed, other); },
          [](const RowCheck& other) { return mean(other.computed); });
    }
    for (std::size_t i = 0; i < table_.faults.size(); ++i) {
      const IndicatorFault& fault = table_.faults[i];
      if (fault_holds_[i]) continue;
      items_.push_back(idle_fault(i, fault_name(fault), publication_.file, fault.at));
      items_.back().source = source();
    }
    return std::move(items_);
  }

 private:
  // Whether a printed number is that of these readings, and what they give for it; also asked of
  // another row's readings, or of other rules.
  using Fits = std::function<bool(const RowCheck&)>;
  using Number = std::function<double(const RowCheck&)>;

  RowCheck checked(const CatalogueEntry& entry, const IndicatorRow& row,
                   std::vector<double> strands, const std::vector<MotorSideRule>& rules) const {
    RowCheck check{&entry, &row, std::move(strands), {}, {}};
    check.computed = indicators_of(entry, check.strands, ratio_.value, rules);
    const auto add_change = [&](const std::vector<double>& moved, double ratio) {
      const Five other = indicators_of(entry, moved, ratio, rules);
      for (std::size_t i = 0; i < indicator_count; ++i) {
        check.tolerance[i] += std::abs(other[i] - check.computed[i]);
      }
    };
    for (std::size_t s = 0; s < check.strands.size(); ++s) {
      std::vector<double> moved = check.strands;
      moved[s] += publication_.read_to_N;
      add_change(moved, ratio_.value);
    }
    add_change(check.strands, ratio_.value + ratio_.tolerance);
    return check;
  }

  std::string source() const { return publication_.name + ", " + table_.source; }

  void add(const RowCheck& check, const PrintedNumber& printed, const CheckedQuantity& quantity,
           const Fits& fits, const Number& number) {
    CheckItem item;
    item.routing = check.row->routing;
    item.source = source();
    item.quantity = quantity;
    item.printed = printed.digits;
    item.published = printed.value;
    item.computed = number(check);
    if (fits(check)) {
      item.status = CheckStatus::agrees;
    } else {
      explain(item, check, fits, number);
    }
    items_.push_back(std::move(item));
  }

  void explain(CheckItem& item, const RowCheck& check, const Fits& fits, const Number& number) {
    for (std::size_t i = 0; i < table_.faults.size(); ++i) {
      const auto reason =
          std::visit([&](const auto& what) { return reason_of(what, item, check, fits, number); },
                     table_.faults[i].what);
      if (!reason) continue;
      fault_holds_[i] = true;
      add_explanation(item, *reason);
    }
    if (item.status == CheckStatus::differs) {
      item.reason = fmt::format(
          "{} is printed, the readings give {:.3f}, and no listed fault "
          "explains it",
          item.printed, item.computed);
    }
  }

  std::optional<std::string> reason_of(const SlidesToHandFault& fault, const CheckItem& item,
                                       const RowCheck& check, const Fits& fits,
                                       const Number& number) const {
    if (fault.routing != check.row->routing) return std::nullopt;
    std::vector<MotorSideRule> rules = check.row->motor_side;
    for (MotorSideRule& rule : rules) {
      if (rule.strand == fault.strand) rule.to_motor = false;
    }
    const RowCheck turned = checked(*check.entry, *check.row, check.strands, rules);
    if (!fits(turned)) return std::nullopt;
    return fmt::format(
        "{} follows if the tendon is taken to slide out of the sheath at T{}, from the motor to "
        "the hand ({:.3f}); it is pulled into it, so that T_M has T{} / {:.3f} and not T{} x {:.3f}",
        item.printed, fault.strand, number(turned), fault.strand, ratio_.value, fault.strand,
        ratio_.value);
  }

  double squared_difference(const IndicatorRow& row, const RowCheck& check) const {
    double squares = 0;
    for (std::size_t i = 0; i < indicator_count; ++i) {
      squares += std::pow(row.printed[i].value - check.computed[i], 2);
    }
    return squares;
  }

  const RowCheck* find(const std::string& routing) const {
    for (const RowCheck& check : rows_) {
      if (check.row->routing == routing) return &check;
    }
    return nullptr;
  }

  std::optional<std::string> reason_of(const ExchangedFault& fault, const CheckItem& item,
                                       const RowCheck& check, const Fits& fits,
                                       const Number&) const {
    const RowCheck* a = find(fault.routings[0]);
    const RowCheck* b = find(fault.routings[1]);
    if (a == nullptr || b == nullptr || (check.row != a->row && check.row != b->row)) {
      return std::nullopt;
    }
    const RowCheck& other = check.row == a->row ? *b : *a;
    const double own = squared_difference(*a->row, *a) + squared_difference(*b->row, *b);
    const double exchanged = squared_difference(*b->row, *a) + squared_difference(*a->row, *b);
    if (exchanged >= own || !fits(other)) return std::nullopt;
    return fmt::format(
        "{} is beyond what the readings of {} allow ({:.3f}) and what those of {} give; the rows of "
        "{} and {} fit each other's readings better than their own (sum of squared differences "
        "{:.4f} instead of {:.4f}); exchanged, {} has the mean {} and {} {}",
        item.printed, check.row->routing, item.computed, other.row->routing, a->row->routing,
        b->row->routing, exchanged, own, a->row->routing, b->row->mean.digits, b->row->routing,
        a->row->mean.digits);
  }

  const Publication& publication_;
  const IndicatorTable& table_;
  Uncertain ratio_;
  std::vector<RowCheck> rows_;
  std::vector<CheckItem> items_;
  std::vector<bool> fault_holds_;
};

}  // namespace

std::vector<double> strand_readings(const Publication& publication, const CatalogueEntry& entry,
                                    const MeasuredData& readings) {
  const Reading* found = nullptr;
  for (const Reading& reading : readings.readings) {
    if (readings.routings[reading.routing].word != entry.word || reading.grasp != entry.grasp ||
        reading.direction != Direction::pull) {
      continue;
    }
    if (found != nullptr) {
      throw InputError(
          {.where = fmt::format("{}:{}", readings.file, reading.line),
           .expected = fmt::format("one row of {} that pulls in the grasp of its published "
                                   "numbers, which {} derives from",
                                   entry.name, publication.file)});
    }
    found = &reading;
  }
  if (found == nullptr) {
    throw InputError(
        {.where = publication.file,
         .what = fmt::format("its readings, {}, have no row of {} that pulls in the grasp of its "
                             "published numbers",
                             readings.file, entry.name)});
  }
  const auto strands = strand_tensions(readings, *found);
  const bool taut =
      strands && std::ranges::all_of(*strands, [](double tension) { return tension > 0; });
  if (!taut) {
    throw InputError(
        {.where = fmt::format("{}:{}", readings.file, found->line),
         .expected = fmt::format("a tension above 0 in every strand, which {} derives from",
                                 publication.file)});
  }
  return *strands;
}

const CatalogueEntry& entry_of(const Catalogue& catalogue, const Publication& publication,
                               const std::string& routing) {
  const CatalogueEntry* entry = catalogue.find_name(routing);
  if (entry == nullptr) {
    throw InputError({.where = publication.file,
                      .what = "routing",
                      .value = fmt::format("\"{}\"", routing),
                      .expected = "the name of a routing in the catalogue",
                      .form = InputForm::equals});
  }
  return *entry;
}

Uncertain implied_ratio(const Catalogue& catalogue, const Publication& publication,
                        const MeasuredData& readings) {
  constexpr double best = 10;
  const IndicatorRow& row = *publication.indicators->find(publication.indicators->ratio_from);
  const CatalogueEntry& entry = entry_of(catalogue, publication, row.routing);
  require_sheaths_that_slide_so(publication, entry, row);
  const std::vector<double> strands = strand_readings(publication, entry, readings);
  const auto index = static_cast<std::size_t>(row.motor_side.front().strand - 1);
  const PrintedNumber& printed = row.printed[transmission];
  const auto count = static_cast<double>(strands.size());
  const double ratio = strands[index] * count * printed.value / (best * sum(strands));
  return {ratio, ratio * (publication.read_to_N * (1 / strands[index] + count / sum(strands)) +
                          printed.half_unit / printed.value)};
}

std::vector<CheckItem> check_indicators(const Catalogue& catalogue, const Publication& publication,
                                        const MeasuredData& readings) {
  return IndicatorCheck(catalogue, publication, readings).run();
}

}  // namespace reeve::studies
