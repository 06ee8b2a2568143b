#include "diagnosis/comparison.hpp"

#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <map>
#include <numeric>
#include <utility>

#include "core/error.hpp"
#include "diagnosis/fit/forecast.hpp"

namespace reeve::diagnosis {
namespace {

struct Sums {
  std::size_t count = 0;
  double measured = 0;
  double residual = 0;
  double squared = 0;

  void add(const ComparedValue& value) {
    ++count;
    measured += value.measured;
    residual += value.residual();
    squared += value.residual() * value.residual();
  }

  ResidualSummary summary(std::string group) const {
    constexpr double none = std::numeric_limits<double>::quiet_NaN();
    const auto n = static_cast<double>(count);
    const double mean = count == 0 ? none : measured / n;
    const double rms = count == 0 ? none : std::sqrt(squared / n);
    return {std::move(group),
            count,
            mean,
            count == 0 ? none : residual / n,
            rms,
            mean > 0 ? rms / mean : none};
  }
};

// One summary for each value of `key`, in its order.
template <typename Key, typename Label>
std::vector<ResidualSummary> group(const std::vector<const ComparedValue*>& values, Key key,
                                   Label label) {
  std::map<std::uint64_t, Sums> groups;
  for (const ComparedValue* value : values) groups[key(*value)].add(*value);
  std::vector<ResidualSummary> summaries;
  summaries.reserve(groups.size());
  for (const auto& [which, sums] : groups) summaries.push_back(sums.summary(label(which)));
  return summaries;
}

QuantitySummary summarise(const std::vector<ComparedValue>& all, ComparedQuantity quantity,
                          const MeasuredData& data) {
  Sums sums;
  std::vector<const ComparedValue*> values;
  for (const ComparedValue& value : all) {
    if (value.quantity != quantity) continue;
    values.push_back(&value);
    sums.add(value);
  }
  const auto of_reading = [&](auto member) {
    return [&data, member](const ComparedValue& v) { return member(data.readings[v.reading]); };
  };
  QuantitySummary result;
  result.all = sums.summary("all");
  result.by_routing = group(values, of_reading([](const Reading& r) { return r.routing; }),
                            [&](std::size_t i) { return data.routings[i].word; });
  result.by_channel = group(
      values, [](const ComparedValue& v) { return v.channel; },
      [&](std::size_t i) { return data.channels[i].name; });
  result.by_grasp = group(values, of_reading([](const Reading& r) { return r.grasp.held; }),
                          [](std::uint64_t held) { return to_text(Grasp{held}); });
  result.by_direction = group(
      values, of_reading([](const Reading& r) { return static_cast<std::uint64_t>(r.direction); }),
      [](std::uint64_t direction) { return direction == 0 ? "pull" : "release"; });
  result.by_run = group(values, of_reading([](const Reading& r) { return r.run; }),
                        [&](std::size_t i) { return data.runs[i]; });
  std::erase_if(values, [&](const ComparedValue* v) { return !data.readings[v->reading].group; });
  result.by_group = group(values, of_reading([](const Reading& r) { return *r.group; }),
                          [&](std::size_t i) { return data.groups[i]; });
  return result;
}

std::vector<std::size_t> all_readings(const MeasuredData& data) {
  std::vector<std::size_t> readings(data.readings.size());
  std::iota(readings.begin(), readings.end(), std::size_t{0});
  return readings;
}

class Comparer {
 public:
  Comparer(const MeasuredData& data, const Model& model)
      : data_(data),
        dataset_(dataset(data, all_readings(data), Rows::all)),
        forecast_(forecast(dataset_, model)) {}

  Comparison run() {
    for (std::size_t r = 0; r < dataset_.rows.size(); ++r) {
      const DatasetRow& row = dataset_.rows[r];
      if (forecast_.jams[r]) jams_.lines.push_back(data_.readings[row.reading].line);
      if (row.has_motor_tension) {
        add_tensions(row);
      } else {
        add_shares(row);
      }
    }
    if (result_.values.empty()) {
      throw InputError({.where = data_.file,
                        .what = "there is nothing to compare",
                        .expected = "rows with motor_tension_N, or with the tensions of two "
                                    "strands that are not all slack"});
    }
    result_.tension = summarise(result_.values, ComparedQuantity::tension, data_);
    result_.share = summarise(result_.values, ComparedQuantity::share, data_);
    for (DataNote* note : {&jams_, &not_strands_, &too_few_, &slack_}) {
      if (!note->lines.empty()) result_.notes.push_back(std::move(*note));
    }
    return std::move(result_);
  }

 private:
  double predicted(std::size_t cell) const {
    return forecast_.reading_N[static_cast<Eigen::Index>(cell)];
  }

  void add_tensions(const DatasetRow& row) {
    for (std::size_t i = row.first; i < row.last; ++i) {
      const Cell& cell = dataset_.cells[i];
      result_.values.push_back(
          {row.reading, cell.channel, ComparedQuantity::tension, cell.measured_N, predicted(i)});
    }
  }

  void add_shares(const DatasetRow& row) {
    const std::size_t line = data_.readings[row.reading].line;
    std::vector<std::size_t> strands;
    double measured_sum = 0;
    double predicted_sum = 0;
    for (std::size_t i = row.first; i < row.last; ++i) {
      const Cell& cell = dataset_.cells[i];
      if (data_.channels[cell.channel].segment.kind != SegmentKind::strand) continue;
      strands.push_back(i);
      measured_sum += cell.measured_N;
      predicted_sum += predicted(i);
    }
    if (strands.size() < row.last - row.first) not_strands_.lines.push_back(line);
    if (strands.size() < 2) {
      too_few_.lines.push_back(line);
    } else if (!(measured_sum > 0 && predicted_sum > 0)) {
      slack_.lines.push_back(line);
    } else {
      for (const std::size_t i : strands) {
        const Cell& cell = dataset_.cells[i];
        result_.values.push_back({row.reading, cell.channel, ComparedQuantity::share,
                                  cell.measured_N / measured_sum, predicted(i) / predicted_sum});
      }
    }
  }

  const MeasuredData& data_;
  Dataset dataset_;
  Forecast forecast_;
  Comparison result_;
  DataNote jams_{NoteKind::jams,
                 "in these grasps a tendon has no finger that can move: the predictions are those "
                 "of the blocked carriage",
                 {}};
  DataNote not_strands_{NoteKind::not_compared,
                        "without motor_tension_N only shares of strands are compared: other "
                        "segments' tensions are left out",
                        {}};
  DataNote too_few_{NoteKind::not_compared,
                    "without motor_tension_N a row needs the tensions of two strands: it is left "
                    "out",
                    {}};
  DataNote slack_{NoteKind::not_compared,
                  "the measured strands are all slack, in the row or in the model, and have no "
                  "shares: the row is left out",
                  {}};
};

}  // namespace

const char* quantity_name(ComparedQuantity quantity) {
  return quantity == ComparedQuantity::tension ? "tension" : "share";
}

Comparison compare(const MeasuredData& data, const Model& model) {
  return Comparer(data, model).run();
}

}  // namespace reeve::diagnosis
