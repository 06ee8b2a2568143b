#include "studies/strand_readings.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "core/error.hpp"
#include "readings/measured_shares.hpp"

namespace reeve::studies {

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

}  // namespace reeve::studies
