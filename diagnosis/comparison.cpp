#include "diagnosis/comparison.hpp"

#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <map>
#include <utility>

#include "core/error.hpp"
#include "diagnosis/model/prediction.hpp"

namespace reeve {
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

QuantitySummary summarise(const std::vector<ComparedValue>& all, Quantity quantity,
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
  return result;
}

class Comparer {
 public:
  Comparer(const MeasuredData& data, const Hardware& hardware)
      : data_(data), predictor_(data, hardware) {}

  Comparison run() {
    for (std::size_t i = 0; i < data_.readings.size(); ++i) {
      const TensionState& state = predictor_.at(data_.readings[i]);
      if (state.jams) jams_.lines.push_back(data_.readings[i].line);
      if (data_.readings[i].motor_tension_N) {
        add_tensions(i, state);
      } else {
        add_shares(i, state);
      }
    }
    if (result_.values.empty()) {
      throw InputError(
          data_.file +
          ": there is nothing to compare: expected rows with motor_tension_N, or with the tensions "
          "of two strands that are not all slack");
    }
    result_.tension = summarise(result_.values, Quantity::tension, data_);
    result_.share = summarise(result_.values, Quantity::share, data_);
    for (DataNote* note : {&jams_, &not_strands_, &too_few_, &slack_}) {
      if (!note->lines.empty()) result_.notes.push_back(std::move(*note));
    }
    return std::move(result_);
  }

 private:
  void add_tensions(std::size_t index, const TensionState& state) {
    const Reading& reading = data_.readings[index];
    const MeasuredRouting& routing = data_.routings[reading.routing];
    for (std::size_t c = 0; c < data_.channels.size(); ++c) {
      if (!reading.tension_N[c]) continue;
      result_.values.push_back({index, c, Quantity::tension, *reading.tension_N[c],
                                *reading.motor_tension_N * state.tension[*routing.segments[c]]});
    }
  }

  void add_shares(std::size_t index, const TensionState& state) {
    const Reading& reading = data_.readings[index];
    const MeasuredRouting& routing = data_.routings[reading.routing];
    std::vector<std::size_t> strands;
    double measured = 0;
    double predicted = 0;
    bool others = false;
    for (std::size_t c = 0; c < data_.channels.size(); ++c) {
      if (!reading.tension_N[c]) continue;
      if (data_.channels[c].segment.kind != SegmentKind::strand) {
        others = true;
        continue;
      }
      strands.push_back(c);
      measured += *reading.tension_N[c];
      predicted += state.tension[*routing.segments[c]];
    }
    if (others) not_strands_.lines.push_back(reading.line);
    if (strands.size() < 2) {
      too_few_.lines.push_back(reading.line);
    } else if (!(measured > 0 && predicted > 0)) {
      slack_.lines.push_back(reading.line);
    } else {
      for (const std::size_t c : strands) {
        result_.values.push_back({index, c, Quantity::share, *reading.tension_N[c] / measured,
                                  state.tension[*routing.segments[c]] / predicted});
      }
    }
  }

  const MeasuredData& data_;
  Predictor predictor_;
  Comparison result_;
  DataNote jams_{NoteKind::jams,
                 "in these grasps a tendon has no finger that can move: predicted are the tensions "
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

const char* name(Quantity quantity) { return quantity == Quantity::tension ? "tension" : "share"; }

Comparison compare(const MeasuredData& data, const Hardware& hardware) {
  return Comparer(data, hardware).run();
}

}  // namespace reeve
