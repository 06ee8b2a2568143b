#include "reports/exploration/part_words.hpp"

#include <fmt/format.h>

#include "reports/data_text.hpp"

namespace reeve::reports {
namespace {

// "tube,bearing" as "tube, bearing".
std::string spaced_list(const std::string& list) {
  std::string text;
  for (const char c : list) text += c == ',' ? std::string(", ") : std::string(1, c);
  return text.empty() ? "none" : text;
}

std::string blocks_text(int blocks) {
  return plural(static_cast<std::size_t>(blocks), "floating block");
}

// "2 to 4 floating blocks"; "" if there are none.
std::string left_out_blocks(const LeftOutParts& left_out) {
  if (left_out.from_blocks > left_out.to_blocks) return "";
  std::string most = blocks_text(left_out.to_blocks);
  if (left_out.from_blocks == left_out.to_blocks) return most;
  return fmt::format("{} to {}", left_out.from_blocks, most);
}

}  // namespace

std::string parts_text(const PartSet& parts) {
  std::string text = fmt::format("tips {}; joins {}; ends {}", spaced_list(tips_text(parts)),
                                 spaced_list(joins_text(parts)), spaced_list(ends_text(parts)));
  if (parts.anchored) text += "; anchored tips";
  if (parts.blocks > 0) text += "; up to " + blocks_text(parts.blocks);
  if (parts.motors > 1) text += fmt::format("; {} motors", parts.motors);
  if (!parts.beside.empty()) text += "; beside ends " + spaced_list(beside_text(parts));
  for (const PartSwitch& part : part_switches) {
    if (parts.*part.is_in) text += std::string("; ") + part.words;
  }
  return text;
}

std::string routings_text(const GeneratorOptions& generator) {
  return fmt::format("{}; {}; {} fingers", parts_text(generator.parts),
                     generator.one_tendon ? "one tendon" : "any number of tendons",
                     generator.identity == FingerIdentity::identical ? "identical" : "distinct");
}

std::string left_out_text(const LeftOutParts& left_out) {
  const std::string blocks = left_out_blocks(left_out);
  std::string parts = left_out.anchored ? "anchored tips" : blocks;
  if (left_out.anchored && !blocks.empty()) parts += " and " + blocks;
  const bool is_one = !left_out.anchored && left_out.to_blocks == 1;
  // Blocks that were asked for may be too many for anchored tips, which fewer blocks have.
  const bool gives_way = left_out.anchored && blocks.empty() && left_out.from_blocks > 1;
  const std::string favoured =
      gives_way ? fmt::format(" in favour of --blocks {}", left_out.from_blocks - 1) : "";
  const std::string next =
      left_out.anchored ? "--anchored" : fmt::format("--blocks {}", left_out.from_blocks);
  return fmt::format(
      "{} {} left out{}: with {} there are at least {} routings, and the default adds parts up to "
      "{}",
      parts, is_one ? "is" : "are", favoured, next, left_out.routings, left_out.limit);
}

Json parts_json(const PartSet& parts) {
  Json json{{"tips", tips_text(parts)},
            {"joins", joins_text(parts)},
            {"ends", ends_text(parts)},
            {"anchored", parts.anchored},
            {"blocks", parts.blocks}};
  if (parts.motors > 1) json["motors"] = parts.motors;
  if (!parts.beside.empty()) json["beside_ends"] = beside_text(parts);
  for (const PartSwitch& part : part_switches) {
    if (parts.*part.is_in) json[part.name] = true;
  }
  return json;
}

Json left_out_json(const std::optional<LeftOutParts>& left_out) {
  if (!left_out) return nullptr;
  return {{"anchored", left_out->anchored},
          {"from_blocks", left_out->from_blocks},
          {"to_blocks", left_out->to_blocks},
          {"routings", left_out->routings},
          {"limit", left_out->limit}};
}

Document count_sheet(const CountReport& report) {
  const std::string unit = report.parts.blocks > 0 ? "tree" : "tendon";
  Table table{{text_column("routings"), number_column("number")}, {}};
  table.add({"all", std::to_string(report.counts.all)});
  table.add({"every " + unit + " actuated", std::to_string(report.counts.actuated)});
  table.add({"actuated, one " + unit, std::to_string(report.counts.one_tendon)});
  std::vector<DocumentLine> lines{{"Parts: " + parts_text(report.parts)}};
  if (report.left_out) lines.push_back({left_out_text(*report.left_out)});
  if (!report.limited) return {{{"", table, lines}}};
  for (std::size_t c = 0; c < report.constraints.size(); ++c) {
    table.add({"actuated, first to fail " + report.constraints[c].text,
               std::to_string(report.limited->rejected[c])});
  }
  table.add({"actuated, all constraints met", std::to_string(report.limited->meeting)});
  table.add({"… and one " + unit, std::to_string(report.limited->one_tendon)});
  return {{{"", table, lines}}};
}

std::string count_json(const CountReport& report) {
  const RoutingCounts& counts = report.counts;
  Json json{{"all", counts.all}, {"actuated", counts.actuated}, {"one_tendon", counts.one_tendon}};
  json["parts"] = parts_json(report.parts);
  json["left_out"] = left_out_json(report.left_out);
  if (!report.limited) return print(json);
  json["constraints"] = Json::array();
  for (std::size_t c = 0; c < report.constraints.size(); ++c) {
    json["constraints"].push_back(
        {{"constraint", report.constraints[c].text}, {"rejected", report.limited->rejected[c]}});
  }
  json["meeting"] = report.limited->meeting;
  json["meeting_one_tendon"] = report.limited->one_tendon;
  return print(json);
}

}  // namespace reeve::reports
