#include "catalog/fault.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <utility>

namespace reeve::catalog {
namespace {

// Returns another entry's list of the same kind; for a figure, of the same figure.
std::optional<PrintedList> counterpart(const CatalogueEntry& entry, const PrintedList& list) {
  for (PrintedList& other : printed_lists(entry)) {
    if (other.kind != list.kind || other.drawn != list.drawn) continue;
    if (!list.drawn || other.source == list.source) return std::move(other);
  }
  return std::nullopt;
}

const char* noun(PrintedKind kind) { return kind == PrintedKind::tension ? "tension" : "share"; }

std::string count_of(int count, const char* kind, const char* symbol) {
  if (count == 0) return "";
  return fmt::format("{} {} loss{} e^(-{})", count, kind, count == 1 ? "" : "es", symbol);
}

// "1 sheath loss e^(-phi_s)"
std::string describe(const Losses& losses) {
  std::string text;
  for (const std::string& part :
       {count_of(losses.sheath, "sheath", "phi_s"), count_of(losses.tube, "tube", "phi_t"),
        count_of(losses.bearing, "bearing", "phi_b")}) {
    if (!part.empty()) text += (text.empty() ? "" : " and ") + part;
  }
  return text;
}

std::string describe(const FactorFault& fault, const Hardware& hardware) {
  const std::string losses = describe(fault.left_out);
  std::string times = fault.times == 1 ? "" : fmt::format("times {:g}", fault.times);
  if (losses.empty()) return times;
  const std::string without =
      fmt::format("without {} (times {:.4g})", losses, 1 / decay(fault.left_out, hardware));
  return times.empty() ? without : times + " and " + without;
}

std::string names(const std::vector<int>& strands) {
  std::string text;
  for (const int strand : strands) text += fmt::format("{}T{}", text.empty() ? "" : ", ", strand);
  return text;
}

std::vector<double> faulty_tensions(const FactorFault& fault, const Hardware& hardware,
                                    std::vector<double> tension) {
  for (std::size_t i = 0; i < tension.size(); ++i) {
    const auto strand = static_cast<int>(i + 1);
    if (concerns(fault, strand)) tension[i] *= fault.times / decay(fault.left_out, hardware);
  }
  return tension;
}

std::optional<std::string> explain(const FactorFault& fault, const DifferingNumber& number) {
  const Hardware& hardware = number.list.hardware;
  const std::vector<double> tension = faulty_tensions(fault, hardware, number.solution.tension);
  const std::string& digits = number.printed().digits;
  if (number.list.kind == PrintedKind::tension) {
    const double faulty = tension[number.strand];
    if (!rounds_to(faulty, number.printed())) return std::nullopt;
    return fmt::format("{} is the computed {:.4g} {}, which gives {:.4g}", digits,
                       number.computed(), describe(fault, hardware), faulty);
  }
  const double faulty = shares_percent(tension)[number.strand];
  if (!rounds_to(faulty, number.printed())) return std::nullopt;
  return fmt::format("{} % is the share with {} {}, which gives {:.4g} %", digits,
                     names(fault.strands), describe(fault, hardware), faulty);
}

std::optional<std::string> explain(const RepeatsFault& fault, const DifferingNumber& number) {
  const CatalogueEntry* other = number.catalogue.find_name(fault.routing);
  if (other == nullptr) return std::nullopt;
  const std::optional<PrintedList> theirs = counterpart(*other, number.list);
  if (!theirs) return std::nullopt;
  const auto& own = number.list.numbers;
  const bool same =
      std::ranges::equal(own, theirs->numbers, {}, &PrintedNumber::digits, &PrintedNumber::digits);
  if (!same) return std::nullopt;
  return fmt::format("all {} {}s of {} repeat those of {}, for {}, digit by digit", own.size(),
                     noun(number.list.kind), number.list.source, theirs->source, other->name);
}

struct ScaleRange {
  double low = 0;
  double high = std::numeric_limits<double>::infinity();

  void narrow(ScaleRange other) { *this = {std::max(low, other.low), std::min(high, other.high)}; }
  bool empty() const { return low > high; }
};

// Returns the range of factors f with f · base = printed, given that base is known to ± half_unit.
ScaleRange scales(const PrintedNumber& printed, double base, double half_unit) {
  const double most = base - half_unit;
  return {(printed.value - printed.half_unit) / (base + half_unit),
          most > 0 ? (printed.value + printed.half_unit) / most
                   : std::numeric_limits<double>::infinity()};
}

std::optional<std::string> explain(const ProportionalFault& fault, const DifferingNumber& number) {
  const CatalogueEntry* other = number.catalogue.find_name(fault.routing);
  if (number.list.kind != PrintedKind::tension || other == nullptr || !other->table) {
    return std::nullopt;
  }
  const std::vector<PrintedNumber>& own = number.entry.table->tension;
  ScaleRange to_printed;
  ScaleRange to_computed;
  for (std::size_t i = 0; i < own.size(); ++i) {
    const PrintedNumber& theirs = other->table->tension[i];
    to_printed.narrow(scales(own[i], theirs.value, theirs.half_unit));
    to_computed.narrow(scales(own[i], number.solution.tension[i], 0));
  }
  if (to_printed.empty() || !to_computed.empty()) return std::nullopt;
  return fmt::format(
      "{} is the {} printed in {} for {} times one number between {:.3f} and {:.3f}, as are all {} "
      "tensions of {}; no one number turns the computed tensions into them, and where the number "
      "comes from is not known",
      number.printed().digits, other->table->tension[number.strand].digits, other->table->source,
      other->name, to_printed.low, to_printed.high, own.size(), number.entry.table->source);
}

std::optional<std::string> explain(const ReversedContactFault&, const DifferingNumber&) {
  return std::nullopt;
}

}  // namespace

bool concerns(const FactorFault& fault, int strand) {
  return std::ranges::find(fault.strands, strand) != fault.strands.end();
}

std::vector<PrintedList> printed_lists(const CatalogueEntry& entry) {
  std::vector<PrintedList> lists;
  if (entry.table) {
    lists.push_back({entry.table->source, PrintedKind::tension, false, entry.table->tension, {}});
    lists.push_back(
        {entry.table->source, PrintedKind::share, false, entry.table->share_percent, {}});
  }
  for (const PublishedLines& lines : entry.lines) {
    lists.push_back(
        {lines.source, PrintedKind::share, true, lines.share_percent, with_friction(lines.mu)});
  }
  return lists;
}

std::vector<double> with_factor_faults(const CatalogueEntry& entry, const Hardware& hardware,
                                       std::vector<double> tension) {
  for (const Fault& fault : entry.faults) {
    const auto* factor = std::get_if<FactorFault>(&fault.what);
    if (factor != nullptr) tension = faulty_tensions(*factor, hardware, std::move(tension));
  }
  return tension;
}

double DifferingNumber::computed() const {
  return list.kind == PrintedKind::tension ? solution.tension[strand]
                                           : solution.share_percent[strand];
}

std::optional<std::string> explain(const Fault& fault, const DifferingNumber& number) {
  return std::visit([&](const auto& what) { return explain(what, number); }, fault.what);
}

CarriageBalance carriage_balance(const ReversedContactFault& fault, const ClosedForm& form) {
  const double strand = decay(form.strand[static_cast<std::size_t>(fault.strand - 1)]);
  const double sheath = decay({0, 0, 1});
  double others = 0;
  for (std::size_t i = 0; i < form.carriage.size(); ++i) {
    if (i != fault.motor_side) others += decay(form.carriage[i]);
  }
  const double weaker = gain(form) * (others + strand * sheath);
  const double stronger = gain(form) * (others + strand / sheath);
  return fault.printed_strand_higher ? CarriageBalance{weaker, stronger}
                                     : CarriageBalance{stronger, weaker};
}

}  // namespace reeve::catalog
