#include <string>

#include "core/notation.hpp"
#include "fuzz/fuzzed.hpp"
#include "readings/log/logged_series.hpp"
#include "readings/measured_data.hpp"
#include "reports/exploration/shard_file.hpp"

namespace reeve::fuzz {

void readings(std::string_view bytes) {
  or_refused([&] {
    const readings::MeasuredData data = diagnosis::parse_measured_data(
        std::string(bytes), "fuzz.csv",
        [](const std::string& text) { return core::parse_routing(text); });
    for (const readings::Reading& reading : data.readings) {
      require(reading.routing < data.routings.size(), "a reading is of a routing");
      require(reading.run < data.runs.size(), "a reading is of a run");
    }
  });
}

void series(std::string_view bytes) {
  or_refused([&] { readings::parse_logged_series(std::string(bytes), "fuzz.csv"); });
}

void shard(std::string_view bytes) {
  or_refused([&] { reports::shard_file_of(std::string(bytes), "shard.json"); });
}

}  // namespace reeve::fuzz
