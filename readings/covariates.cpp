#include "readings/covariates.hpp"

#include <fmt/format.h>

#include <utility>

#include "readings/csv.hpp"

namespace reeve::readings {

void Covariates::finish(MeasuredData& data, FaultList& faults) const {
  std::vector<std::size_t> kept;
  for (std::size_t i = 0; i < names_.size(); ++i) {
    if (is_of_words(i)) {
      data.notes.push_back(
          {NoteKind::passed_over,
           fmt::format("column '{}' has words and is none that is known: it is not read",
                       for_message(names_[i])),
           {}});
      continue;
    }
    faults.add(columns_[i].faults);
    kept.push_back(i);
    data.covariates.push_back(names_[i]);
  }
  if (kept.size() == names_.size()) return;
  for (Reading& reading : data.readings) {
    std::vector<std::optional<double>> values;
    for (const std::size_t i : kept) values.push_back(reading.covariates[i]);
    reading.covariates = std::move(values);
  }
}

}  // namespace reeve::readings
