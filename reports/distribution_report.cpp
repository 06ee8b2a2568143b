#include "reports/distribution_report.hpp"

#include "reports/data_text.hpp"

namespace reeve::reports {
namespace {

const char* word(FrictionKind kind) {
  switch (kind) {
    case FrictionKind::coefficient:
      return "coefficient";
    case FrictionKind::model:
      return "model";
    case FrictionKind::diagnosed:
      return "diagnosed";
  }
  return "";
}

Json strand_json(const StrandShare& strand) {
  Json json{{"strand", strand.strand}, {"model", number(strand.model)},
            {"published", nullptr},    {"published_fault", nullptr},
            {"measured", nullptr},     {"measured_deviation", nullptr}};
  if (strand.published) {
    json["published"] = strand.published->share;
    json["published_fault"] = text_or_null(strand.published->fault);
  }
  if (strand.measured) {
    json["measured"] = strand.measured->mean;
    if (strand.measured->deviation) json["measured_deviation"] = *strand.measured->deviation;
  }
  return json;
}

Json shares_json(const RoutingShares& routing) {
  Json json{{"routing", routing.word},
            {"name", text_or_null(routing.name)},
            {"published_source", text_or_null(routing.published_source)},
            {"readings", routing.readings}};
  json["strands"] = Json::array();
  for (const StrandShare& strand : routing.strands) json["strands"].push_back(strand_json(strand));
  return json;
}

}  // namespace

Json to_json(const TensionDistribution& distribution) {
  const bool one = distribution.kind == FrictionKind::coefficient;
  Json json{{"mu", one ? Json(distribution.tube_mu) : Json(nullptr)},
            {"friction", word(distribution.kind)},
            {"tube_mu", distribution.tube_mu},
            {"sheath_mu", distribution.sheath_mu},
            {"held", held_fingers(distribution.grasp)}};
  json["rms_measured"] = value_or_null(distribution.rms_measured, number);
  json["share_error"] = value_or_null(distribution.share_errors.model, number);
  json["published_share_error"] = value_or_null(distribution.share_errors.published, number);
  json["routings"] = Json::array();
  for (const RoutingShares& routing : distribution.routings) {
    json["routings"].push_back(shares_json(routing));
  }
  return json;
}

Json to_json(const SharedData& data) {
  Json json{{"file", data.file}, {"simulated", data.simulated}, {"notes", Json::array()}};
  add_notes(json["notes"], data.notes);
  return json;
}

}  // namespace reeve::reports
