#include "core/grasp.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cctype>
#include <charconv>
#include <cmath>
#include <utility>

#include "core/error.hpp"
#include "core/nearest_name.hpp"
#include "core/network.hpp"

namespace reeve::core {
namespace {

std::vector<std::string> split(const std::string& text, char separator) {
  std::vector<std::string> parts;
  std::size_t at = 0;
  while (true) {
    const std::size_t next = std::min(text.find(separator, at), text.size());
    parts.push_back(text.substr(at, next - at));
    if (next == text.size()) return parts;
    at = next + 1;
  }
}

template <typename Number>
bool read(const std::string& text, Number& number) {
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  return error == std::errc{} && end == text.data() + text.size();
}

constexpr double most_travel = 100;
const std::string none_held = "none";

struct ReadGrasp {
  Grasp grasp;
  std::optional<InputFault> fault;
};

std::string expected_fingers(int fingers) {
  if (fingers == 0) return "none: there is no finger";
  if (fingers == 1) return "none or 1";
  return fmt::format("none, or finger numbers from 1 to {} such as 1,2", fingers);
}

// "'none': expected it alone, or 'b' without it" of "none,b".
InputFault beside_none(std::vector<std::string> items) {
  std::erase(items, none_held);
  const std::string rest = fmt::format("{}", fmt::join(items, ","));
  return {.value = none_held,
          .expected = "it alone" + (rest.empty() ? "" : ", or '" + rest + "' without it")};
}

std::optional<InputFault> lock(const std::string& item, int motor_side, const MotorEnds& ends,
                               std::uint64_t& named, Grasp& grasp) {
  if (ends.empty()) {
    return InputFault{.value = item,
                      .expected =
                          "no locked end: they are for one routing, or several whose ends "
                          "at motors have the same names"};
  }
  if (motor_side > static_cast<int>(ends.size())) {
    const Segment last{SegmentKind::motor_side, static_cast<int>(ends.size())};
    return InputFault{.value = item,
                      .expected = "a motor-side segment from a to " + segment_name(last)};
  }
  const std::uint64_t bit = std::uint64_t{1} << (motor_side - 1);
  if ((named & bit) != 0) return InputFault{.what = item + " is named twice"};
  named |= bit;
  grasp.locked |= ends[static_cast<std::size_t>(motor_side) - 1];
  if (static_cast<std::size_t>(std::popcount(grasp.locked)) < ends.size()) return std::nullopt;
  return InputFault{.what = "every end at a motor is locked", .expected = "one that moves"};
}

ReadGrasp read_grasp(const std::string& text, int fingers, const MotorEnds& ends) {
  Grasp grasp;
  if (text == none_held) return {grasp, std::nullopt};
  std::uint64_t named = 0;
  const std::vector<std::string> items = split(text, ',');
  for (const std::string& item : items) {
    int finger = 0;
    if (item == none_held) return {grasp, beside_none(items)};
    const auto segment = segment_named(item);
    if (segment && segment->kind == SegmentKind::motor_side && segment->number <= most_lockable) {
      if (auto fault = lock(item, segment->number, ends, named, grasp)) return {grasp, fault};
      continue;
    }
    if (!read(item, finger) || finger < 1 || finger > fingers) {
      return {grasp, InputFault{.value = item, .expected = expected_fingers(fingers)}};
    }
    if (grasp.holds(finger)) {
      return {grasp, InputFault{.what = fmt::format("finger {} is named twice", finger)}};
    }
    grasp.held |= hold({finger}).held;
  }
  return {grasp, std::nullopt};
}

// Error messages begin with `where`, the text that the user gave.
CarriageTravels require_travels(const std::string& text, int motors, const std::string& where) {
  if (motors < 2) {
    throw InputError({.where = where,
                      .value = "@" + text,
                      .expected =
                          "no travels of carriages: they are for one routing, or several of "
                          "the same number of motors, with more than one motor"});
  }
  CarriageTravels travels;
  bool any_pulls = false;
  bool all_read = true;
  for (const std::string& item : split(text, ',')) {
    if (travels.given == motors) {
      all_read = false;
      break;
    }
    double& travel = travels.over_D[travels.given++];
    all_read &= read(item, travel) && std::abs(travel) <= most_travel;
    any_pulls |= travel > 0;
  }
  if (!all_read || travels.given < motors || !any_pulls) {
    throw InputError({.where = where,
                      .value = "@" + text,
                      .expected = fmt::format("{} travels from -{} to {}, one of each motor's "
                                              "carriage and one at least above 0, such as {}",
                                              motors, most_travel, most_travel,
                                              motors == 2 ? "@1,-1" : "@1,0.5,0")});
  }
  return travels;
}

// Error messages begin with `where`, the text that the user gave.
Grasp require_grasp(const std::string& text, int fingers, int motors, const MotorEnds& ends,
                    const std::string& where) {
  const std::size_t travels = text.find('@');
  ReadGrasp read = read_grasp(text.substr(0, travels), fingers, ends);
  if (read.fault) throw InputError(std::move(*read.fault)).at(where);
  if (travels != std::string::npos) {
    read.grasp.carriages = require_travels(text.substr(travels + 1), motors, where);
  }
  return read.grasp;
}

WeightedGrasp parse_weighted(const std::string& item, const std::string& text, int fingers,
                             int motors, const MotorEnds& ends) {
  const std::vector<std::string> parts = split(item, ':');
  const std::string where = fmt::format("grasps '{}'", text);
  WeightedGrasp result{require_grasp(parts[0], fingers, motors, ends, where), 1};
  if (parts.size() == 1) return result;
  if (parts.size() > 2 || !read(parts[1], result.weight) || !(result.weight >= 1e-6) ||
      !(result.weight <= 1e6)) {
    throw InputError({.where = where,
                      .value = item,
                      .expected = "a held list and a weight from 1e-6 to 1e6, such as 1,2:0.5"});
  }
  return result;
}

// "al": of letters alone, and neither "none" nor an end at a motor.
bool is_misspelt_set(const std::string& text, const MotorEnds& ends) {
  const bool is_word =
      text.size() > 1 && text != none_held &&
      std::all_of(text.begin(), text.end(), [](unsigned char c) { return std::isalpha(c) != 0; });
  if (!is_word) return false;
  const auto segment = segment_named(text);
  return !segment || segment->number > static_cast<int>(ends.size());
}

double weight_of(const Grasp& grasp, const GraspSet& grasps) {
  double weight = 0;
  for (const WeightedGrasp& weighted : grasps) {
    if (weighted.grasp == grasp) weight += weighted.weight;
  }
  return weight;
}

// The grasp with this finger and the next one renamed to each other.
Grasp exchanged(Grasp grasp, int finger) {
  if (grasp.holds(finger) != grasp.holds(finger + 1)) {
    grasp.held ^= hold({finger, finger + 1}).held;
  }
  return grasp;
}

}  // namespace

Grasp hold(const std::vector<int>& fingers) {
  Grasp grasp;
  for (const int finger : fingers) grasp.held |= std::uint64_t{1} << (finger - 1);
  return grasp;
}

std::vector<int> held_fingers(const Grasp& grasp) {
  std::vector<int> fingers;
  for (int finger = 1; finger <= max_fingers; ++finger) {
    if (grasp.holds(finger)) fingers.push_back(finger);
  }
  return fingers;
}

std::vector<double> carriage_travels(const Grasp& grasp) {
  const auto* const first = grasp.carriages.over_D.begin();
  return {first, first + grasp.carriages.given};
}

std::vector<std::string> locked_ends(const Grasp& grasp) {
  std::vector<std::string> names;
  for (int number = 1; number <= most_lockable; ++number) {
    if (grasp.locks(number)) names.push_back(segment_name({SegmentKind::motor_side, number}));
  }
  return names;
}

std::string locked_words(const Grasp& grasp) {
  const std::vector<std::string> ends = locked_ends(grasp);
  if (ends.empty()) return "";
  return fmt::format(", end{} {} locked", ends.size() > 1 ? "s" : "", fmt::join(ends, ", "));
}

std::string to_text(const Grasp& grasp) {
  std::string text = fmt::format("{}", fmt::join(held_fingers(grasp), ","));
  for (const std::string& end : locked_ends(grasp)) text += (text.empty() ? "" : ",") + end;
  if (text.empty()) text = none_held;
  if (grasp.carriages.given == 0) return text;
  return text + fmt::format("@{}", fmt::join(carriage_travels(grasp), ","));
}

std::optional<Grasp> grasp_named(const std::string& text, int fingers) {
  const ReadGrasp read = read_grasp(text, fingers, {});
  return read.fault ? std::nullopt : std::optional(read.grasp);
}

Grasp parse_grasp(const std::string& text, int fingers, int motors, const MotorEnds& ends) {
  return require_grasp(text, fingers, motors, ends, fmt::format("held '{}'", text));
}

GraspSet single_grasps(int fingers) {
  GraspSet grasps{{Grasp{}, 1}};
  for (int finger = 1; finger <= fingers; ++finger) grasps.push_back({hold({finger}), 1});
  return grasps;
}

GraspSet all_grasps(int fingers) {
  constexpr int most = 16;
  if (fingers > most) {
    throw InputError({.where = "grasps 'all'",
                      .what = fmt::format("{} fingers have 2^{} grasps", fingers, fingers),
                      .expected = fmt::format("at most {} fingers, or another set", most),
                      .form = InputForm::unknown});
  }
  GraspSet grasps;
  const std::uint64_t everything = (std::uint64_t{1} << fingers) - 1;
  for (std::uint64_t held = 0; held < everything; ++held) grasps.push_back({Grasp{held}, 1});
  return grasps;
}

GraspSet paper_grasps() { return {{hold({1}), 1}}; }

GraspSet parse_grasps(const std::string& text, int fingers, int motors, const MotorEnds& ends) {
  if (text == "single") return single_grasps(fingers);
  if (text == "all") return all_grasps(fingers);
  if (text == "paper") return paper_grasps();
  if (is_misspelt_set(text, ends)) {
    throw InputError({.what = "grasps",
                      .value = text,
                      .expected = "single, all, paper, or held fingers such as none/1/1,2" +
                                  did_you_mean(text, {"single", "all", "paper", none_held})});
  }
  GraspSet grasps;
  for (const std::string& item : split(text, '/')) {
    const WeightedGrasp grasp = parse_weighted(item, text, fingers, motors, ends);
    if (weight_of(grasp.grasp, grasps) > 0) {
      throw InputError({.where = fmt::format("grasps '{}'", text),
                        .what = fmt::format("'{}' is given twice", to_text(grasp.grasp))});
    }
    grasps.push_back(grasp);
  }
  return grasps;
}

bool treats_fingers_alike(const GraspSet& grasps, int fingers) {
  for (const WeightedGrasp& weighted : grasps) {
    if (weighted.grasp.locked != 0) return false;
    // Exchanges of neighbours make every renaming.
    for (int finger = 1; finger < fingers; ++finger) {
      if (weight_of(exchanged(weighted.grasp, finger), grasps) != weighted.weight) return false;
    }
  }
  return true;
}

Grasp opened(const Grasp& grasp) { return {0, grasp.carriages, grasp.locked}; }

std::vector<Grasp> opened(const GraspSet& grasps) {
  std::vector<Grasp> open_grasps;
  for (const auto& [grasp, weight] : grasps) {
    const Grasp open = opened(grasp);
    if (std::ranges::find(open_grasps, open) == open_grasps.end()) open_grasps.push_back(open);
  }
  return open_grasps;
}

bool treats_motors_alike(const GraspSet& grasps) {
  for (const auto& [grasp, weight] : grasps) {
    for (std::size_t motor = 1; motor < grasp.carriages.given; ++motor) {
      Grasp other = grasp;
      std::swap(other.carriages.over_D[motor - 1], other.carriages.over_D[motor]);
      if (weight_of(other, grasps) != weight) return false;
    }
  }
  return true;
}

std::string to_text(const GraspSet& grasps) {
  std::string text;
  for (const WeightedGrasp& weighted : grasps) {
    if (!text.empty()) text += '/';
    text += to_text(weighted.grasp);
    if (weighted.weight != 1) text += fmt::format(":{}", weighted.weight);
  }
  return text;
}

}  // namespace reeve::core
