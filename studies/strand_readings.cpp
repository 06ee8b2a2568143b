#include "studies/strand_readings.hpp"

#include <fmt/format.h>

#include "core/error.hpp"

namespace reeve {

std::vector<double> strand_readings(const Publication& publication, const CatalogueEntry& entry,
                                    const MeasuredData& readings) {
  for (const Reading& reading : readings.readings) {
    if (readings.routings[reading.routing].word != entry.word) continue;
    std::vector<double> strands(2 * static_cast<std::size_t>(finger_count(entry.routing)), -1);
    for (std::size_t c = 0; c < readings.channels.size(); ++c) {
      const Segment& segment = readings.channels[c].segment;
      if (segment.kind != SegmentKind::strand || !reading.tension_N[c]) continue;
      strands[static_cast<std::size_t>(segment.number - 1)] = *reading.tension_N[c];
    }
    for (const double tension : strands) {
      if (tension > 0) continue;
      throw InputError(
          fmt::format("{}:{}: expected a tension above 0 in every strand, which {} "
                      "derives from",
                      readings.file, reading.line, publication.file));
    }
    return strands;
  }
  throw InputError(fmt::format("{}: its readings, {}, have no row of {}", publication.file,
                               readings.file, entry.name));
}

const CatalogueEntry& entry_of(const Catalogue& catalogue, const Publication& publication,
                               const std::string& routing) {
  const CatalogueEntry* entry = catalogue.find_name(routing);
  if (entry == nullptr) {
    throw InputError(
        fmt::format("{}: routing = \"{}\": expected the name of a routing in the "
                    "catalogue",
                    publication.file, routing));
  }
  return *entry;
}

}  // namespace reeve
