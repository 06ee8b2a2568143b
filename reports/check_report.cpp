#include "reports/check_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>

#include "drawing/schematic/schematic_svg.hpp"
#include "reports/output/json.hpp"

namespace reeve::reports {
namespace {

constexpr std::array indicator_names{"adaptability", "torsional balance", "reliability",
                                     "authors' efficiency", "transmission"};

std::string number_text(double value) { return fmt::format("{:.4g}", value); }

std::string published_text(const CheckItem& item) {
  return item.printed.empty() ? number_text(item.published) : item.printed;
}

std::string place(const CheckItem& item) {
  return fmt::format("{}{}, {}", item.routing.empty() ? "" : item.routing + " ", item.source,
                     quantity_text(item));
}

Section reasons(const CheckReport& report, const char* title,
                const std::vector<CheckStatus>& statuses) {
  Section section{title, std::nullopt, {}};
  for (const CheckItem& item : report.items) {
    const bool listed = std::ranges::find(statuses, item.status) != statuses.end();
    if (item.reason.empty() || !listed) continue;
    section.lines.push_back({fmt::format("{}: {}", place(item), item.reason)});
  }
  return section;
}

Section inferences(const CheckReport& report) {
  Section section{"Coefficients that a printed number gave", std::nullopt, {}};
  // printed number, and the mechanisms that use it
  std::vector<std::pair<std::string, std::string>> uses;
  for (const CheckItem& item : report.items) {
    if (item.inferred_from.empty()) continue;
    const auto same = std::ranges::find_if(
        uses, [&](const auto& use) { return use.first == item.inferred_from; });
    if (same == uses.end()) {
      uses.emplace_back(item.inferred_from, item.routing);
    } else if (!same->second.ends_with(item.routing)) {
      same->second += ", " + item.routing;
    }
  }
  for (const auto& [number, mechanisms] : uses) {
    section.lines.push_back({fmt::format("{}: {}", number, mechanisms)});
  }
  return section;
}

Section misprints(const CheckReport& report) {
  Section section{"Misprints that change no number", std::nullopt, {}};
  for (const CheckedMisprint& misprint : report.misprints) {
    section.lines.push_back(
        {fmt::format("{} {}: {}", misprint.routing, misprint.source, misprint.text)});
  }
  return section;
}

Tint tint(CheckStatus status) {
  if (status == CheckStatus::differs) return Tint::bad;
  const bool is_fine = status == CheckStatus::agrees || status == CheckStatus::used;
  return is_fine ? Tint::none : Tint::notable;
}

std::string counts_text(const CheckReport& report, const std::string& family) {
  const auto count = [&](CheckStatus status) { return report.count(status, family); };
  std::string text = fmt::format("{} agree", count(CheckStatus::agrees));
  if (const auto used = count(CheckStatus::used); used > 0) text += fmt::format(", {} used", used);
  text += fmt::format(", {} explained", count(CheckStatus::explained));
  if (const auto refuted = count(CheckStatus::refuted); refuted > 0) {
    text += fmt::format(", {} refuted", refuted);
  }
  if (const auto open = count(CheckStatus::open); open > 0) text += fmt::format(", {} open", open);
  return text + fmt::format(", {} differ", count(CheckStatus::differs));
}

Section family_section(const CheckReport& report, const std::string& family) {
  Table table{{text_column("routing"), text_column("source"), text_column("quantity"),
               number_column("published"), number_column("computed"), text_column("status")},
              {}};
  for (const CheckItem& item : report.items) {
    if (item.family != family) continue;
    table.add({item.routing.empty() ? "-" : item.routing, item.source, quantity_text(item),
               published_text(item), number_text(item.computed), status_name(item.status)},
              tint(item.status));
  }
  return {family, table, {{counts_text(report, family)}}};
}

Json item_json(const CheckItem& item) {
  return {{"family", item.family},
          {"routing", text_or_null(item.routing)},
          {"source", item.source},
          {"quantity", quantity_text(item)},
          {"published", number(item.published)},
          {"computed", number(item.computed)},
          {"status", status_name(item.status)},
          {"inferred_from", text_or_null(item.inferred_from)},
          {"reason", text_or_null(item.reason)}};
}

}  // namespace

std::string quantity_text(const CheckedQuantity& quantity) {
  switch (quantity.kind) {
    case CheckedKind::strand_tension:
      return fmt::format("T{}", quantity.number);
    case CheckedKind::strand_share:
      return fmt::format("share of T{}, %", quantity.number);
    case CheckedKind::motor_tension:
      return "T_M that the printed tensions ask for";
    case CheckedKind::motor_tension_of_equation:
      return "T_M that the equation as printed asks for";
    case CheckedKind::idle_fault:
      return fmt::format("numbers explained by listed fault {}", quantity.number);
    case CheckedKind::tension_sum:
      return "sum of the strand tensions, N";
    case CheckedKind::indicator:
      return indicator_names.at(static_cast<std::size_t>(quantity.number - 1));
    case CheckedKind::indicator_mean:
      return "mean of the five indicators";
    case CheckedKind::share_error:
      return "error of the printed shares, %";
    case CheckedKind::share_error_of_equations:
      return "error of the equations' shares, %";
    case CheckedKind::friction_coefficient:
      return "friction coefficient";
    case CheckedKind::design_count:
      return fmt::format("designs of {} fingers", quantity.number);
    case CheckedKind::in_words:
      return "";
  }
  return "";
}

std::string quantity_text(const CheckItem& item) {
  return item.quantity.kind == CheckedKind::in_words ? item.in_words : quantity_text(item.quantity);
}

std::string catalogue_document(const std::vector<ShownEntry>& entries) {
  constexpr std::size_t in_a_row = 4;
  std::vector<Schematic> schematics;
  for (const ShownEntry& entry : entries) {
    const GraspView view{entry.grasp, Direction::pull, entry.state};
    schematics.push_back(schematic(entry.network, entry.title, view, false));
  }
  return schematic_sheet(schematics, in_a_row, "Routings of the catalogue");
}

Document check_sheet(const CheckReport& report) {
  Document document;
  for (const std::string& family : report.families()) {
    document.add(family_section(report, family));
  }
  document.add(reasons(report, "Why they differ",
                       {CheckStatus::agrees, CheckStatus::explained, CheckStatus::differs}));
  document.add(
      reasons(report, "Used: a coefficient was inferred from these numbers", {CheckStatus::used}));
  document.add(
      reasons(report, "Refuted: what these numbers would require", {CheckStatus::refuted}));
  document.add(reasons(report, "Open: they differ for an unknown reason", {CheckStatus::open}));
  document.add(inferences(report));
  document.add(misprints(report));
  document.add({"", std::nullopt, {{counts_text(report, "")}}});
  return document;
}

std::string check_json(const CheckReport& report) {
  Json json;
  json["checks"] = list_json(report.items, item_json);
  json["misprints"] = list_json(report.misprints, [](const CheckedMisprint& misprint) {
    return Json{{"family", misprint.family},
                {"routing", misprint.routing},
                {"source", misprint.source},
                {"text", misprint.text}};
  });
  for (const CheckStatus status : check_statuses) {
    json[status_name(status)] = report.count(status);
  }
  json["families"] = list_json(report.families(), [&](const std::string& family) {
    Json counts{{"family", family}};
    for (const CheckStatus status : check_statuses) {
      counts[status_name(status)] = report.count(status, family);
    }
    return counts;
  });
  json["version"] = version_json();
  return print(json);
}

}  // namespace reeve::reports
