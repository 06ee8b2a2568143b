#include "pages/exploration/exploration_details.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <unordered_map>
#include <utility>

#include "core/notation.hpp"
#include "drawing/schematic/schematic_svg.hpp"
#include "numerics/parallel.hpp"
#include "pages/shell/compressed.hpp"
#include "reports/jam_words.hpp"

namespace reeve::pages {
namespace {

// More shares more lines; fewer is less to unpack for one design.
constexpr std::size_t chunk_size = 16;
constexpr std::size_t chunks_at_once = 32;

class Lines {
 public:
  // The numbers of its lines, neighbours as ranges: "0-7 12 8-9".
  std::string add(const std::string& text) {
    std::string runs;
    std::size_t first = 0;
    std::size_t last = 0;
    bool open = false;
    for (std::size_t begin = 0; begin < text.size();) {
      const std::size_t end = std::min(text.find('\n', begin), text.size());
      const std::string line = text.substr(begin, end - begin);
      begin = end + 1;
      const auto [found, is_new] = numbers_.try_emplace(line, numbers_.size());
      const std::size_t number = found->second;
      if (is_new) text_ += line + "\n";
      if (open && number == last + 1) {
        last = number;
        continue;
      }
      if (open) runs += run(first, last) + " ";
      first = last = number;
      open = true;
    }
    return runs + run(first, last);
  }

  // All of them, each with its end.
  const std::string& text() const { return text_; }

 private:
  static std::string run(std::size_t first, std::size_t last) {
    return first == last ? std::to_string(first) : fmt::format("{}-{}", first, last);
  }

  std::unordered_map<std::string, std::size_t> numbers_;
  std::string text_;
};

double three_decimals(double value) { return std::round(1000 * value) / 1000; }

std::string placed_svg(const SolvedRouting& report, const Places& places, std::size_t grasp,
                       const std::string& ids) {
  const ShownGrasp& shown = report.grasps[grasp];
  return schematic_svg(schematic(report.network, places, report.title(),
                                 GraspView{shown.grasp, report.direction, shown.state}, false),
                       ids);
}

Json grasp_json(const SolvedRouting& report, std::size_t grasp) {
  const ShownGrasp& shown = report.grasps[grasp];
  return {{"held", to_text(shown.grasp)},
          {"jams", shown.state.jams},
          {"tensions", list_json(shown.state.tension, three_decimals)}};
}

Json design_json(const SolvedRouting& report, bool whole, Lines& lines) {
  Json json{{"segments", Json::array()}, {"strands", Json::array()}};
  for (std::size_t i = 0; i < report.network.segments.size(); ++i) {
    json["segments"].push_back(segment_name(report.network.segments[i]));
    if (report.network.segments[i].kind == SegmentKind::strand) json["strands"].push_back(i);
  }
  if (std::string shared = shared_carriage_text(report.network, report.model.hardware.tendon);
      !shared.empty()) {
    json["shared"] = std::move(shared);
  }
  json["grasps"] = Json::array();
  const Places places = reeve::drawing::places(report.network);
  for (std::size_t i = 0; i < report.grasps.size(); ++i) {
    Json grasp = grasp_json(report, i);
    if (whole || i == 0) grasp["schematic"] = lines.add(placed_svg(report, places, i, "schematic"));
    json["grasps"].push_back(std::move(grasp));
  }
  json["contacts"] = list_json(shown_contacts(report), [](const ShownContact& contact) {
    return Json{{"between", contact.between}, {"kind", contact.kind}, {"slides", contact.slides}};
  });
  return json;
}

struct Chunk {
  std::vector<const Routing*> routings;
  bool whole = true;
};

Json packed(const Chunk& chunk, const SolveDesign& solve) {
  Lines lines;
  const Json designs = list_json(chunk.routings, [&](const Routing* routing) {
    return design_json(solve(*routing), chunk.whole, lines);
  });
  const std::string values = designs.dump(-1, ' ', false, Json::error_handler_t::replace);
  return {{"words",
           list_json(chunk.routings, [](const Routing* routing) { return to_word(*routing); })},
          {"pack", compressed(values + "\n" + lines.text())}};
}

// A chunk holds no more than that, and either whole designs or others.
std::vector<Chunk> cut(const DetailedDesigns& designs) {
  std::vector<Chunk> chunks;
  for (const bool whole : {true, false}) {
    const std::vector<const Routing*>& some = whole ? designs.whole : designs.brief;
    for (std::size_t at = 0; at < some.size(); at += chunk_size) {
      const auto begin = some.begin() + static_cast<std::ptrdiff_t>(at);
      const auto count = static_cast<std::ptrdiff_t>(std::min(chunk_size, some.size() - at));
      chunks.push_back({{begin, begin + count}, whole});
    }
  }
  return chunks;
}

// Returns the size of {"words": …, "pack": …} in the page; nothing in a pack has to be escaped.
std::size_t size_in_page(const Json& chunk) {
  constexpr std::size_t around = 24;
  return around + chunk["words"].dump().size() + chunk["pack"].get_ref<const std::string&>().size();
}

}  // namespace

DesignDetails design_details(const DetailedDesigns& designs, const SolveDesign& solve,
                             std::size_t bytes, int threads) {
  Workers workers(threads);
  DesignDetails details;
  const std::vector<Chunk> pending = cut(designs);
  for (std::size_t at = 0; at < pending.size(); at += chunks_at_once) {
    std::vector<Json> made(std::min(chunks_at_once, pending.size() - at));
    workers.for_each_block(made.size(), 1, [&](const IndexBlock& block) {
      for (std::size_t i = block.begin; i < block.end; ++i)
        made[i] = packed(pending[at + i], solve);
    });
    for (std::size_t i = 0; i < made.size(); ++i) {
      const std::size_t more = size_in_page(made[i]);
      if (details.bytes + more > bytes) return details;
      details.bytes += more;
      (pending[at + i].whole ? details.designs : details.brief) += pending[at + i].routings.size();
      details.chunks.push_back(std::move(made[i]));
    }
  }
  return details;
}

std::string grasp_svg(const SolvedRouting& report, std::size_t grasp, const std::string& ids) {
  return placed_svg(report, places(report.network), grasp, ids);
}

}  // namespace reeve::pages
