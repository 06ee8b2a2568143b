#include <fmt/format.h>

#include <cmath>
#include <iterator>

#include "readings/csv.hpp"
#include "reports/data_text.hpp"
#include "reports/import_report.hpp"
#include "reports/output/csv_field.hpp"
#include "reports/output/json.hpp"

namespace reeve::reports {
namespace {

class ImportedCsv {
 public:
  explicit ImportedCsv(const ImportReport& report) : report_(report), series_(report.series) {}

  std::string write(const std::string& command) {
    put_comments(command);
    put_header();
    for (const SteadyReading& reading : report_.steady.readings) put_row(reading);
    return fmt::to_string(out_);
  }

 private:
  template <typename... Values>
  void put(fmt::format_string<Values...> format, Values&&... values) {
    fmt::format_to(std::back_inserter(out_), format, std::forward<Values>(values)...);
  }

  // A name with the word that marks simulated data must not make measured ones of that kind.
  void put_comments(const std::string& command) {
    put("# steady readings out of a logger's time series, by reeve {}\n", version_json());
    bool said = false;
    for (const std::string& comment : series_.comments) {
      put("#{}\n", one_line(comment));
      said |= says_simulated(comment);
    }
    if (series_.simulated && !said) put("# {}\n", simulated_text);
    const std::string line = one_line(command);
    if (series_.simulated || !says_simulated(line)) {
      put("# command: {}\n", line);
    }
  }

  void put_header() {
    put("run,routing,held,direction");
    if (series_.motor_tension_N.is_logged()) put(",motor_tension_N");
    if (has_speed()) put(",speed_mm_s");
    for (const LoggedSignal& tension : series_.tensions_N) put(",{}", tension.name);
    for (const LoggedSignal& other : series_.others) put(",{}", csv_field(other.name));
    put(",readings");
    if (series_.motor_tension_N.is_logged()) put(",motor_tension_sd_N");
    for (const LoggedSignal& tension : series_.tensions_N) {
      put(",{}_sd_N", tension_words(tension));
    }
    put(",time_s\n");
  }

  bool has_speed() const {
    return series_.position_mm.is_logged() || series_.speed_mm_s.is_logged();
  }

  void put_number(const std::optional<double>& value, int digits) {
    put(",");
    if (value && std::isfinite(*value)) put("{:.{}g}", *value, digits);
  }

  void put_row(const SteadyReading& reading) {
    const LogLabels& label = report_.labels[reading.label];
    put("{},{},{},{}", csv_field(label.run), csv_field(label.routing), csv_field(label.held),
        direction_field(reading.direction));
    const auto mean = [](const std::optional<AveragedTension>& tension) {
      return tension ? std::optional(tension->mean_N) : std::nullopt;
    };
    const auto deviation = [](const std::optional<AveragedTension>& tension) {
      return tension ? std::optional(tension->deviation_N) : std::nullopt;
    };
    if (series_.motor_tension_N.is_logged()) put_number(mean(reading.motor_tension_N), 6);
    if (has_speed()) put_number(reading.speed_mm_s, 4);
    for (const auto& tension : reading.tensions_N) put_number(mean(tension), 6);
    for (const auto& other : reading.others) put_number(other, 9);
    put(",{}", reading.readings);
    if (series_.motor_tension_N.is_logged()) put_number(deviation(reading.motor_tension_N), 4);
    for (const auto& tension : reading.tensions_N) put_number(deviation(tension), 4);
    put(",{:.3f}\n", reading.time_s);
  }

  const ImportReport& report_;
  const LoggedSeries& series_;
  fmt::memory_buffer out_;
};

}  // namespace

std::string imported_csv(const ImportReport& report, const std::string& command) {
  return ImportedCsv(report).write(command);
}

}  // namespace reeve::reports
