#include "tests/support/planting_experiment.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <set>
#include <tuple>
#include <utility>

#include "tests/support/planting_walk.hpp"
#include "tests/support/published_words.hpp"

namespace reeve::testing {
namespace {

constexpr double least_motor_N = 5;
constexpr double greatest_motor_N = 60;
constexpr double greatest_tension_N = 300;

const std::vector<std::string>& further_words() {
  static const std::vector<std::string> words{
      "M-1b-T-2b-F",   "M-1-B-2-F",       "M-1b-P-2b-M",    "M-1-F+M-2-F",
      "M-1-T-2-T-3-F", "M-1-P-2-T-3-F",   "F-1-P-2-P-3-F",  "M-1b-B-2b-B-3b-M",
      "1-T-2-P-3-P-1", "M-1-T-2-F+M-3-F", "1-P-2-P-3b-P-1", "M-1-B-2-P-3-F"};
  return words;
}

std::vector<std::string> some_of(std::vector<std::string> words, int count, Dice& dice) {
  dice.shuffle(words);
  words.resize(std::min(words.size(), static_cast<std::size_t>(count)));
  return words;
}

std::vector<std::string> with_bearings(std::vector<std::string> words) {
  std::erase_if(words, [](const std::string& word) { return !has_bearing(word); });
  return words;
}

std::vector<std::string> choose_words(const ExperimentNeeds& needs, Dice& dice) {
  auto words = some_of(needs.bearings ? with_bearings(published_words()) : published_words(),
                       dice.integer(2, 4), dice);
  const auto further = some_of(needs.bearings ? with_bearings(further_words()) : further_words(),
                               dice.integer(1, 2), dice);
  words.insert(words.end(), further.begin(), further.end());
  return words;
}

// Routings of each run: every routing is in two of them at least.
std::vector<std::vector<std::string>> assign(const std::vector<std::string>& words, int runs,
                                             Dice& dice) {
  std::vector<std::vector<std::string>> routings(static_cast<std::size_t>(runs));
  for (std::size_t i = 0; i < std::max(2 * words.size(), routings.size()); ++i) {
    routings[i % routings.size()].push_back(words[i % words.size()]);
  }
  for (auto& of_run : routings) {
    if (dice.chance(0.3)) of_run.push_back(dice.pick(words));
  }
  dice.shuffle(routings);
  return routings;
}

// ---- conditions ----

double rounded(double value, double unit) { return std::round(value / unit) * unit; }

struct Course {
  std::optional<double> speed_mm_s, cycle, temperature_C;  // empty: not recorded
};

// One quantity: it varies, or it stays at the value where its effect vanishes, or is not recorded.
enum class Record { varies, nominal, none };

Record record(bool needed, Dice& dice) {
  if (needed || dice.chance(0.5)) return Record::varies;
  return dice.chance(0.5) ? Record::nominal : Record::none;
}

std::optional<double> value(Record record, double nominal, double varied) {
  if (record == Record::none) return std::nullopt;
  return record == Record::varies ? varied : nominal;
}

class Surroundings {
 public:
  Surroundings(const ExperimentNeeds& needs, int runs, Dice& dice)
      : dice_(dice),
        speed_(record(needs.speed, dice)),
        cycle_(record(needs.cycle, dice)),
        temperature_(record(needs.temperature, dice)),
        last_cycle_(dice.real(1500, 3000)),
        mean_step_(last_cycle_ / (18.0 * runs)) {}

  void start_run() { room_C_ = dice_.real(12, 38); }

  Course next() {
    const double speed = rounded(dice_.log_real(1, 100), 0.1);
    const double temperature = rounded(room_C_ + dice_.real(-2, 2), 0.1);
    const Course now{value(speed_, 10, speed), value(cycle_, 0, std::min(3000.0, cycles_)),
                     value(temperature_, 20, temperature)};
    cycles_ = std::floor(cycles_ + dice_.real(0, 2 * mean_step_));
    return now;
  }

 private:
  Dice& dice_;
  Record speed_, cycle_, temperature_;
  double last_cycle_;
  double mean_step_;
  double cycles_ = 0;
  double room_C_ = 20;
};

// ---- motor tension ----

struct Range {
  double low, high;
};

// Of the nominal tensions at the hand, per newton of motor tension; jams are not measured.
class NominalRatios {
 public:
  std::optional<Range> of(const Condition& condition) {
    const auto key = std::tuple(condition.word, condition.held, condition.direction);
    const auto found = ratios_.find(key);
    if (found != ratios_.end()) return found->second;
    return ratios_.emplace(key, solve(condition)).first->second;
  }

 private:
  static std::optional<Range> solve(const Condition& condition) {
    const ReferenceResult result =
        reference_tensions(condition.word, condition.held, condition.direction, nominal_hardware());
    if (result.jams) return std::nullopt;
    Range range{1, 0};
    for (const auto& [segment, tension] : result.tension) {
      if (is_motor_side(segment)) continue;
      range = {std::min(range.low, tension), std::max(range.high, tension)};
    }
    return range;
  }

  std::map<std::tuple<std::string, std::set<int>, ReferenceDirection>, std::optional<Range>>
      ratios_;
};

double motor_tension(const Range& ratio, double least_tension_N, Dice& dice) {
  const double high = std::min(greatest_motor_N, greatest_tension_N / ratio.high);
  const double low = std::min({std::max(least_motor_N, least_tension_N / ratio.low), high * 0.999});
  return rounded(dice.log_real(low, high), 0.01);
}

// ---- rows ----

std::set<int> random_held(const std::string& word, Dice& dice) {
  const std::set<int> all = fingers_of(word);
  std::vector<int> fingers(all.begin(), all.end());
  const int most = std::min(2, static_cast<int>(fingers.size()) - 1);
  dice.shuffle(fingers);
  fingers.resize(static_cast<std::size_t>(dice.integer(0, most)));
  return {fingers.begin(), fingers.end()};
}

struct Habits {
  double release = 0;  // share of rows
  double missing = 0;  // share of cells
  bool motor_side = false;
};

Habits random_habits(Dice& dice) {
  return {dice.chance(0.25) ? 0.2 : 0.0, dice.chance(0.3) ? 0.1 : 0.0, dice.chance(0.4)};
}

std::vector<std::string> random_sensors(const std::string& word, const Habits& habits, Dice& dice) {
  const std::vector<std::string> all = sensors_of(word, habits.motor_side);
  std::vector<std::string> read = all;
  std::erase_if(read, [&](const std::string&) { return dice.chance(habits.missing); });
  return read.empty() ? all : read;
}

Condition random_grasp(const std::string& word, const Habits& habits, NominalRatios& ratios,
                       Dice& dice) {
  Condition condition;
  condition.word = word;
  do {
    condition.held = random_held(word, dice);
    condition.direction =
        dice.chance(habits.release) ? ReferenceDirection::release : ReferenceDirection::pull;
  } while (!ratios.of(condition));
  return condition;
}

}  // namespace

std::vector<std::string> sensors_of(const std::string& word, bool motor_side) {
  std::vector<std::string> segments;
  for (const reference::Tendon& tendon : reference::read_tendons(word)) {
    for (const reference::Segment& segment : tendon.segments) {
      const bool is_read = segment.place == reference::Place::strand ||
                           (motor_side && segment.place == reference::Place::motor_side);
      if (is_read) segments.push_back(segment.name);
    }
  }
  return segments;
}

std::vector<std::string> channels_of(const std::vector<ExperimentRow>& rows) {
  std::set<std::string> strands, others;
  for (const ExperimentRow& row : rows) {
    for (const std::string& segment : row.measured) {
      (is_strand(segment) ? strands : others).insert(segment);
    }
  }
  std::vector<std::string> channels(strands.begin(), strands.end());
  channels.insert(channels.end(), others.begin(), others.end());
  return channels;
}

Experiment random_experiment(const ExperimentNeeds& needs, Dice& dice) {
  const std::vector<std::string> words = choose_words(needs, dice);
  const int drawn_runs = dice.integer(8, 16);
  const int runs = needs.runs > 0 ? needs.runs : drawn_runs;
  const auto routings = assign(words, runs, dice);
  const Habits habits = random_habits(dice);
  Surroundings surroundings(needs, runs, dice);
  NominalRatios ratios;
  Experiment experiment;
  for (int run = 0; run < runs; ++run) {
    surroundings.start_run();
    const int rows = dice.integer(12, 25);
    for (int i = 0; i < rows; ++i) {
      const std::string& word = dice.pick(routings[static_cast<std::size_t>(run)]);
      Condition condition = random_grasp(word, habits, ratios, dice);
      condition.motor_tension_N =
          motor_tension(ratios.of(condition).value(), needs.least_tension_N, dice);
      const Course now = surroundings.next();
      condition.speed_mm_s = now.speed_mm_s;
      condition.cycle = now.cycle;
      condition.temperature_C = now.temperature_C;
      experiment.rows.push_back(
          {"run " + std::to_string(run + 1), condition, random_sensors(word, habits, dice)});
    }
  }
  experiment.channels = channels_of(experiment.rows);
  return experiment;
}

}  // namespace reeve::testing
