#include "studies/catalogue_check.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numeric>
#include <utility>

#include "catalog/fault.hpp"
#include "catalog/solution.hpp"
#include "core/canonical.hpp"
#include "core/error.hpp"
#include "core/notation.hpp"
#include "diagnosis/verdict/share_error.hpp"
#include "search/enumerate/counting.hpp"
#include "studies/indicator_check.hpp"

namespace reeve::studies {
namespace {

class PublicationCheck {
 public:
  PublicationCheck(const Catalogue& catalogue, const Publication& publication,
                   const MeasuredData& readings)
      : catalogue_(catalogue), publication_(publication), readings_(readings) {}

  std::vector<CheckItem> run() {
    if (publication_.indicators) {
      check_sums();
      std::ranges::move(check_indicators(catalogue_, publication_, readings_),
                        std::back_inserter(items_));
    }
    for (const PublishedError& error : publication_.errors) check_error(error);
    if (publication_.coefficient) check_coefficient(*publication_.coefficient);
    if (publication_.counts) {
      for (const int fingers : publication_.counts->fingers) check_count(fingers);
    }
    return std::move(items_);
  }

 private:
  CheckItem item(const std::string& source, CheckedQuantity quantity) const {
    CheckItem item;
    item.source = publication_.name + ", " + source;
    item.quantity = quantity;
    return item;
  }

  void check_sums() {
    for (const IndicatorRow& row : publication_.indicators->rows) {
      const std::vector<double> strands =
          strand_readings(publication_, entry_of(catalogue_, publication_, row.routing), readings_);
      CheckItem sum = item(publication_.readings_source, {CheckedKind::tension_sum, 0});
      sum.routing = row.routing;
      sum.printed = fmt::format("{}", publication_.sum_N);
      sum.published = publication_.sum_N;
      sum.computed = std::accumulate(strands.begin(), strands.end(), 0.0);
      const double tolerance = publication_.read_to_N * static_cast<double>(strands.size());
      if (std::abs(sum.computed - sum.published) <= tolerance) {
        sum.status = CheckStatus::agrees;
      } else {
        sum.reason = fmt::format(
            "the readings add up to {:.2f} N, which cannot be {} N with {} N "
            "for each",
            sum.computed, sum.printed, publication_.read_to_N);
      }
      items_.push_back(std::move(sum));
    }
  }

  // Shares of one routing: as read, as printed, and as the equations give them.
  struct Lines {
    std::vector<double> read;
    const PrintedList* printed = nullptr;
    std::vector<double> computed;
    std::vector<double> with_faults;
  };

  // How far the error moves if every reading and every printed share is off.
  double tolerance(const Lines& lines) const {
    const std::vector<double> shares = shares_of(*lines.printed);
    const double error = distance_to_shares(lines.read, shares);
    double sum = 0;
    for (std::size_t i = 0; i < shares.size(); ++i) {
      std::vector<double> moved = lines.read;
      moved[i] += publication_.read_to_N;
      sum += std::abs(distance_to_shares(moved, shares) - error);
      moved = shares;
      moved[i] += lines.printed->numbers[i].half_unit / 100;
      sum += std::abs(distance_to_shares(lines.read, moved) - error);
    }
    return sum;
  }

  static std::vector<double> shares_of(const PrintedList& list) {
    std::vector<double> result;
    for (const PrintedNumber& number : list.numbers) result.push_back(number.value / 100);
    return result;
  }

  static bool is_meant(const PublishedError& error, const PrintedList& list) {
    if (list.kind != PrintedKind::share) return false;
    return error.lines == "table" ? !list.drawn : list.source == error.lines;
  }

  void check_error(const PublishedError& error) {
    double printed = 0, computed = 0, with_faults = 0, open = 0;
    std::string faulty;
    std::size_t routings = 0;
    for (const CatalogueEntry& entry : catalogue_.entries) {
      for (const PrintedList& list : printed_lists(entry)) {
        if (!is_meant(error, list)) continue;
        const Hardware hardware = with_friction(error.mu);
        const std::vector<double> tension = solve(entry, hardware).tension;
        const Lines lines{strand_readings(publication_, entry, readings_), &list, tension,
                          with_factor_faults(entry, hardware, tension)};
        printed += 100 * distance_to_shares(lines.read, shares_of(list));
        computed += 100 * share_distance(lines.read, lines.computed);
        with_faults += 100 * share_distance(lines.read, lines.with_faults);
        open += 100 * tolerance(lines);
        if (share_distance(lines.computed, lines.with_faults) > 1e-9) {
          faulty += (faulty.empty() ? "" : " and ") + entry.name;
        }
        ++routings;
      }
    }
    if (routings == 0) {
      throw InputError({.where = fmt::format("{}:{}:{}", publication_.file, error.lines_at.line,
                                             error.lines_at.column),
                        .what = "error.lines",
                        .value = fmt::format("\"{}\"", error.lines),
                        .expected = "\"table\", or the source of [[lines]] in the catalogue",
                        .form = InputForm::equals});
    }
    const auto n = static_cast<double>(routings);
    const std::string source = fmt::format("{}, mu = {}", error.source, error.mu);
    const auto fits = [&](double value) {
      return std::abs(value - error.percent.value) <= error.percent.half_unit + open / n;
    };
    CheckItem lines = item(source, {CheckedKind::share_error, 0});
    lines.printed = error.percent.digits;
    lines.published = error.percent.value;
    lines.computed = printed / n;
    lines.status = fits(lines.computed) ? CheckStatus::agrees : CheckStatus::differs;
    if (lines.status == CheckStatus::differs) {
      lines.reason = fmt::format(
          "mean over {} routings of the root of the summed squared "
          "differences of the shares",
          routings);
    }
    CheckItem equations = lines;
    equations.quantity = {CheckedKind::share_error_of_equations, 0};
    equations.computed = computed / n;
    equations.reason.clear();
    equations.status = CheckStatus::agrees;
    if (!fits(equations.computed)) {
      equations.status = fits(with_faults / n) ? CheckStatus::explained : CheckStatus::differs;
      equations.reason = fmt::format(
          "the equations leave {:.1f} %; with the losses that the lines of {} leave out, {:.1f} %",
          equations.computed, faulty.empty() ? "no routing" : faulty, with_faults / n);
    }
    if (equations.status == CheckStatus::explained) {
      equations.reason += fmt::format(
          ", and so the {} % are reached with lines that are not those of the equations",
          equations.printed);
    }
    items_.push_back(std::move(lines));
    items_.push_back(std::move(equations));
  }

  // As a ratio or as an exponent it would change a transmission that is printed.
  void check_coefficient(const PublishedCoefficient& coefficient) {
    const Uncertain ratio = implied_ratio(catalogue_, publication_, readings_);
    const IndicatorRow& row = *publication_.indicators->find(publication_.indicators->ratio_from);
    CheckItem result = item(coefficient.source, {CheckedKind::friction_coefficient, 0});
    result.printed = coefficient.mu.digits;
    result.published = coefficient.mu.value;
    result.computed = -std::log(ratio.value);
    const auto is_it = [&](double as_ratio) {
      return std::abs(as_ratio - ratio.value) <= ratio.tolerance;
    };
    const double as_exponent = std::exp(-coefficient.mu.value);
    if (is_it(coefficient.mu.value) || is_it(as_exponent)) {
      result.status = CheckStatus::agrees;
    } else {
      result.status = CheckStatus::explained;
      const PrintedNumber& printed = row.printed[indicator_count - 1];
      result.reason = fmt::format(
          "the indicators need a sheath that lets {:.3f} ± {:.3f} through, which is an exponent of "
          "{:.3f}; {} is neither: as the ratio it would make {}'s transmission {:.2f}, as the "
          "exponent {:.2f}, where {} is printed",
          ratio.value, ratio.tolerance, result.computed, coefficient.mu.digits, row.routing,
          printed.value * coefficient.mu.value / ratio.value,
          printed.value * as_exponent / ratio.value, printed.digits);
    }
    items_.push_back(std::move(result));
  }

  void check_count(int fingers) {
    const PublishedCounts& rule = *publication_.counts;
    const int factor = fingers % 2 == 0 ? rule.even_factor : rule.odd_factor;
    CheckItem result = item(rule.source, {CheckedKind::design_count, fingers});
    result.published = std::ldexp(factor, fingers) - 1;
    result.printed = fmt::format("{}", result.published);
    result.computed = static_cast<double>(fixed_order_designs(fingers).size());
    if (result.computed == result.published) {
      result.status = CheckStatus::agrees;
    } else {
      explain_count(fingers, result);
    }
    items_.push_back(std::move(result));
  }

  // Explained where so many designs are what some of the closings make.
  static void explain_count(int fingers, CheckItem& result) {
    const double joins = std::ldexp(1, fingers - 1);
    const double closings = (result.published + 1) / joins;
    const RoutingCounts any_order =
        count_routings(paper_parts(), fingers, FingerIdentity::identical);
    const bool some =
        closings == std::floor(closings) && closings >= 1 && closings < closings_in_fixed_order;
    if (some) result.status = CheckStatus::explained;
    result.reason = fmt::format(
        "{} ways to close the outer strands times {} choices of joins, less the one that no motor "
        "pulls, are {}, for odd numbers of fingers as for even ones; {} are what {} of the {} ways "
        "make, and no reason is known to leave the others out, all of which are pulled and differ "
        "(with fingers in any order {}, of several tendons {})",
        closings_in_fixed_order, joins, result.computed, result.printed, closings,
        closings_in_fixed_order, any_order.one_tendon, any_order.actuated);
  }

  const Catalogue& catalogue_;
  const Publication& publication_;
  const MeasuredData& readings_;
  std::vector<CheckItem> items_;
};

CheckReport check_paper(const Catalogue& catalogue, const CatalogueFiles& files) {
  CheckReport report = check(catalogue);
  const auto routing = [&](const std::string& text) {
    const Routing* named = catalogue.find_routing(text);
    return named == nullptr ? parse_routing(text) : *named;
  };
  for (const Publication& publication : read_publications(files)) {
    const CatalogueFile file = files.find("measured/" + publication.readings);
    const MeasuredData readings = file.text ? parse_measured_data(*file.text, file.name, routing)
                                            : read_measured_data(file.name, routing);
    std::ranges::move(check_publication(catalogue, publication, readings),
                      std::back_inserter(report.items));
  }
  return report;
}

void append(CheckReport part, CheckReport& report) {
  std::ranges::move(part.items, std::back_inserter(report.items));
  std::ranges::move(part.misprints, std::back_inserter(report.misprints));
}

}  // namespace

std::vector<Routing> fixed_order_designs(int fingers) {
  std::vector<Routing> designs;
  for (unsigned joins = 0; joins < 1U << (fingers - 1); ++joins) {
    std::string walk = "1";
    for (int finger = 2; finger <= fingers; ++finger) {
      walk += ((joins >> (finger - 2)) & 1U) != 0 ? "-P-" : "-T-";
      walk += std::to_string(finger);
    }
    for (const std::string& word :
         {"M-" + walk + "-M", "M-" + walk + "-F", "F-" + walk + "-F", walk + "-P-1"}) {
      const Routing routing = canonical(parse_routing(word), FingerIdentity::distinct);
      if (!is_actuated(routing)) continue;
      if (std::ranges::find(designs, routing) == designs.end()) {
        designs.push_back(routing);
      }
    }
  }
  return designs;
}

std::vector<CheckItem> check_publication(const Catalogue& catalogue, const Publication& publication,
                                         const MeasuredData& readings) {
  return PublicationCheck(catalogue, publication, readings).run();
}

CheckReport check_all(const Catalogue& catalogue, const CatalogueFiles& files,
                      const std::optional<std::string>& family) {
  CheckReport report;
  if (!family || *family == paper_family) report = check_paper(catalogue, files);
  for (const Mechanism& mechanism : catalogue.mechanisms) {
    if (!family || *family == mechanism.family) append(check_mechanism(mechanism), report);
  }
  return report;
}

}  // namespace reeve::studies
