#include "catalog/number_check.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

#include "catalog/fault.hpp"
#include "catalog/mechanisms/named_values.hpp"
#include "catalog/solution.hpp"

namespace reeve::catalog {
namespace {

// Closed forms and solver both use exact ratios; what is left is rounding of doubles.
constexpr double equation_tolerance = 1e-9;

bool is_published(double value, const PublishedNumber& number, const NamedValues& values) {
  if (!number.equals) return rounds_to(value, number.printed);
  const double form = number.equals->evaluate(values);
  return std::abs(value - form) <= equation_tolerance * std::abs(form);
}

// Returns the difference in words and relative to the computed value.
std::string difference(const CheckItem& item) {
  const std::string printed =
      item.printed.empty() ? fmt::format("{:.6g}", item.published) : item.printed;
  return fmt::format("{} is published and {:.4g} computed ({:+.1f} %)", printed, item.computed,
                     100 * (item.published / item.computed - 1));
}

// The status holds only if the listed expression gives the number.
void evaluate_by_expression(const PublishedNumber& number, const NamedValues& values,
                            CheckStatus status, CheckItem& item) {
  const double given = number.explained_by->evaluate(values);
  if (is_published(given, number, values)) {
    item.status = status;
    item.reason = fmt::format("{}; {} = {:.4g}: {}", difference(item), number.explained_by->text(),
                              given, number.reason);
  } else {
    item.reason = fmt::format("{}; {} = {:.4g}, which is listed for it, does not give it",
                              difference(item), number.explained_by->text(), given);
  }
}

// A rig that is said to give the number has to give it.
void evaluate_refuted(const PublishedNumber& number, CheckItem& item) {
  item.reason = fmt::format("{}; {}", difference(item), number.reason);
  bool met = true;
  if (number.met_by) {
    const NamedValues values = solved_values(number, *number.met_by);
    const double given = number.computed.evaluate(values);
    met = is_published(given, number, values);
    item.reason += fmt::format("; with it {:.4g}", given);
  }
  if (met) item.status = CheckStatus::refuted;
}

void evaluate_used(const PublishedNumber& number, const NamedValues& values, bool agrees,
                   CheckItem& item) {
  if (number.explained_by) {
    evaluate_by_expression(number, values, CheckStatus::used, item);
  } else if (agrees) {
    item.status = CheckStatus::used;
  } else {
    item.reason = difference(item) + ", though the coefficient is said to be its";
  }
}

void evaluate(const Mechanism& mechanism, const PublishedNumber& number, const NamedValues& values,
              CheckItem& item) {
  const bool agrees = is_published(item.computed, number, values);
  switch (number.standing) {
    case NumberStanding::plain:
      item.status = agrees ? CheckStatus::agrees : CheckStatus::differs;
      if (!agrees) item.reason = difference(item) + ", and nothing is listed for it";
      return;
    case NumberStanding::used:
      evaluate_used(number, values, agrees, item);
      return;
    case NumberStanding::explained:
    case NumberStanding::open:
    case NumberStanding::refuted:
      break;
  }
  if (agrees) {
    item.reason = fmt::format("it agrees, though {}:{}:{} lists it as one that differs",
                              mechanism.file, number.at.line, number.at.column);
  } else if (number.standing == NumberStanding::open) {
    item.status = CheckStatus::open;
    item.reason = fmt::format("{}; {}", difference(item), number.reason);
  } else if (number.standing == NumberStanding::refuted) {
    evaluate_refuted(number, item);
  } else {
    evaluate_by_expression(number, values, CheckStatus::explained, item);
  }
}

CheckItem check_number(const Mechanism& mechanism, const PublishedNumber& number) {
  const NamedValues values = solved_values(number, number.rig);
  CheckItem item;
  item.family = mechanism.family;
  item.routing = mechanism.name;
  item.source = number.source;
  item.quantity = {CheckedKind::in_words, 0};
  item.in_words = number.quantity;
  item.inferred_from = number.rig.inferred_from;
  item.printed = number.equals ? "" : number.printed.digits;
  item.published = number.equals ? number.equals->evaluate(values) : number.printed.value;
  item.computed = number.computed.evaluate(values);
  evaluate(mechanism, number, values, item);
  return item;
}

class EntryCheck {
 public:
  EntryCheck(const Catalogue& catalogue, const CatalogueEntry& entry, CheckReport& report)
      : catalogue_(catalogue),
        entry_(entry),
        solution_(solve(entry)),
        report_(report),
        fault_holds_(entry.faults.size(), false) {}

  void run() {
    check_printed();
    check_closed_form();
    check_faults();
  }

 private:
  void add(CheckItem item) {
    item.routing = entry_.name;
    report_.items.push_back(std::move(item));
  }

  void explain(CheckItem& item, const DifferingNumber& number) {
    for (std::size_t i = 0; i < entry_.faults.size(); ++i) {
      const auto reason = catalog::explain(entry_.faults[i], number);
      if (!reason) continue;
      fault_holds_[i] = true;
      add_explanation(item, *reason);
    }
    if (item.status == CheckStatus::differs) {
      item.reason =
          fmt::format("{} is printed and {:.4g} computed, and no listed fault explains it",
                      item.printed, item.computed);
    }
  }

  CheckItem printed_item(const PrintedList& list, const Solution& solution, std::size_t strand) {
    const DifferingNumber number{catalogue_, entry_, solution, list, strand};
    CheckItem item;
    item.source = list.source;
    item.quantity = {
        list.kind == PrintedKind::tension ? CheckedKind::strand_tension : CheckedKind::strand_share,
        static_cast<int>(strand + 1)};
    item.printed = number.printed().digits;
    item.published = number.printed().value;
    item.computed = number.computed();
    if (rounds_to(item.computed, number.printed())) {
      item.status = CheckStatus::agrees;
    } else {
      explain(item, number);
    }
    return item;
  }

  // The motor-side tensions follow from the printed ones by the sheaths, so a table can be weighed
  // without the solver's own tensions. Its verdict hangs on the strands: replacing the explained
  // ones by the computed ones must balance it.
  CheckItem table_balance(const std::vector<CheckItem>& tensions) const {
    double asked = 0;
    double rounding = 1e-12;
    double repaired = 0;
    double pulled_strands = 0;
    std::set<int> replaced;
    for (const SheathEnds& sheath : solution_.sheaths) {
      const CheckItem& strand = tensions[sheath.strand];
      const bool explained = strand.status == CheckStatus::explained;
      asked += sheath.ratio * strand.published;
      rounding += sheath.ratio * entry_.table->tension[sheath.strand].half_unit;
      repaired += sheath.ratio * (explained ? strand.computed : strand.published);
      if (sheath.ratio >= 1) pulled_strands += strand.published;
      if (explained) replaced.insert(strand.quantity.number);
    }
    CheckItem item;
    item.source = entry_.table->source;
    item.quantity = {CheckedKind::motor_tension, 0};
    item.printed = "1";
    item.published = 1;
    item.computed = asked;
    if (std::abs(asked - 1) <= rounding) {
      item.status = CheckStatus::agrees;
      return item;
    }
    item.reason = fmt::format("the printed tensions ask for a motor tension of {:.3f} ± {:.3f}",
                              asked, rounding);
    if (!replaced.empty() && std::abs(repaired - 1) <= rounding) {
      item.status = CheckStatus::explained;
      item.reason += fmt::format("; with the computed T{} in place of the printed, {:.3f}",
                                 fmt::join(replaced, ", T"), repaired);
    }
    if (pulled_strands > 1) {
      item.reason += fmt::format(
          "; those of the strands that sheaths pull add up to {:.2f}, more than T_M, though a sheath "
          "only takes tension away",
          pulled_strands);
    }
    return item;
  }

  void check_printed() {
    std::vector<CheckItem> table_tensions;
    for (const PrintedList& list : printed_lists(entry_)) {
      const Solution solution = list.drawn ? solve(entry_, list.hardware) : solution_;
      for (std::size_t i = 0; i < list.numbers.size(); ++i) {
        CheckItem item = printed_item(list, solution, i);
        if (list.kind == PrintedKind::tension) table_tensions.push_back(item);
        add(std::move(item));
      }
    }
    if (entry_.table && !solution_.sheaths.empty()) add(table_balance(table_tensions));
  }

  CheckItem closed_form_item(std::size_t strand, double value) const {
    CheckItem item;
    item.source = entry_.closed_form->source;
    item.quantity = {CheckedKind::strand_tension, static_cast<int>(strand + 1)};
    item.published = value;
    item.computed = solution_.tension[strand];
    if (std::abs(item.computed - value) <= equation_tolerance * std::abs(value)) {
      item.status = CheckStatus::agrees;
    } else {
      item.reason =
          fmt::format("the closed form gives {:.6g} and the solver {:.6g}", value, item.computed);
    }
    return item;
  }

  void check_closed_form() {
    if (!entry_.closed_form) return;
    const std::vector<double> values = evaluate(*entry_.closed_form);
    for (std::size_t i = 0; i < values.size(); ++i) add(closed_form_item(i, values[i]));
  }

  CheckItem equation_balance(const ReversedContactFault& fault) const {
    const CarriageBalance balance = carriage_balance(fault, *entry_.closed_form);
    CheckItem item;
    item.source = fault.source;
    item.quantity = {CheckedKind::motor_tension_of_equation, 0};
    item.printed = "1";
    item.published = 1;
    item.computed = balance.as_printed;
    const bool printed_fits = std::abs(balance.as_printed - 1) <= equation_tolerance;
    const bool corrected_fits = std::abs(balance.corrected - 1) <= equation_tolerance;
    if (!printed_fits && corrected_fits) item.status = CheckStatus::explained;
    item.reason = fmt::format(
        "with the sheath between T{} and {} sliding as printed, the motor-side tensions of {} add up "
        "to {:.6f}; with that direction reversed, to {:.6f}",
        fault.strand, fault.segment, entry_.closed_form->source, balance.as_printed,
        balance.corrected);
    return item;
  }

  CheckItem idle_fault(std::size_t fault) const {
    const Fault& listed = entry_.faults[fault];
    CheckItem item = catalog::idle_fault(fault, fault_name(listed), entry_.file, listed.at);
    item.source = entry_.table ? entry_.table->source : entry_.lines.front().source;
    return item;
  }

  void check_faults() {
    for (std::size_t i = 0; i < entry_.faults.size(); ++i) {
      if (const auto* reversed = std::get_if<ReversedContactFault>(&entry_.faults[i].what)) {
        add(equation_balance(*reversed));
      } else if (!fault_holds_[i]) {
        add(idle_fault(i));
      }
    }
  }

  const Catalogue& catalogue_;
  const CatalogueEntry& entry_;
  Solution solution_;
  CheckReport& report_;
  std::vector<bool> fault_holds_;
};

}  // namespace

CheckReport check_mechanism(const Mechanism& mechanism) {
  CheckReport report;
  for (const PublishedNumber& number : mechanism.numbers) {
    report.items.push_back(check_number(mechanism, number));
  }
  for (const Misprint& misprint : mechanism.misprints) {
    report.misprints.push_back({mechanism.name, misprint.source, misprint.text, mechanism.family});
  }
  return report;
}

const char* status_name(CheckStatus status) {
  // In the order of CheckStatus.
  constexpr std::array names{"agrees", "used", "explained", "refuted", "open", "differs"};
  return names.at(static_cast<std::size_t>(status));
}

void add_explanation(CheckItem& item, const std::string& reason) {
  item.status = CheckStatus::explained;
  item.reason += (item.reason.empty() ? "" : "; ") + reason;
}

CheckItem idle_fault(std::size_t fault, const std::string& name, const std::string& file,
                     TomlPosition at) {
  CheckItem item;
  item.quantity = {CheckedKind::idle_fault, static_cast<int>(fault + 1)};
  item.published = 1;
  item.computed = 0;
  item.reason = fmt::format("the listed fault '{}' ({}:{}:{}) explains no number that differs",
                            name, file, at.line, at.column);
  return item;
}

std::size_t CheckReport::count(CheckStatus status, std::string_view family) const {
  return static_cast<std::size_t>(std::ranges::count_if(items, [&](const CheckItem& item) {
    return item.status == status && (family.empty() || item.family == family);
  }));
}

std::vector<std::string> CheckReport::families() const {
  std::vector<std::string> names;
  for (const CheckItem& item : items) {
    if (std::ranges::find(names, item.family) == names.end()) {
      names.push_back(item.family);
    }
  }
  return names;
}

CheckReport check(const Catalogue& catalogue) {
  CheckReport report;
  for (const CatalogueEntry& entry : catalogue.entries) {
    if (entry.table || entry.closed_form || !entry.lines.empty())
      EntryCheck(catalogue, entry, report).run();
    for (const Misprint& misprint : entry.misprints) {
      report.misprints.push_back({entry.name, misprint.source, misprint.text});
    }
  }
  return report;
}

}  // namespace reeve::catalog
