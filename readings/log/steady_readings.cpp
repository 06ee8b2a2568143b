#include "readings/log/steady_readings.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "readings/inverted.hpp"
#include "readings/log/log_notes.hpp"
#include "readings/log/recordings.hpp"
#include "readings/log/settling.hpp"
#include "readings/log/steady_levels.hpp"
#include "readings/rows.hpp"

namespace reeve::readings {
namespace {

constexpr double sweep = 5;  // times the tolerance

class SteadySearch {
 public:
  SteadySearch(const LoggedSeries& series, const SteadyOptions& options)
      : series_(series), options_(options), parts_(recordings(series)) {
    result_.motion = motion_source(series);
    result_.usual_step_s = usual_step(series, parts_.parts);
    width_s_ = block_width(options.min_duration_s, result_.usual_step_s);
    for (const Recording& part : parts_.parts) {
      blocks_.push_back(series_blocks(series, part, width_s_));
    }
    result_.uses.assign(series.size(), SampleUse::load_varies);
  }

  SteadyReadings find() {
    if (result_.motion == MotionSource::none) {
      find_levels();
    } else {
      find_sliding();
    }
    result_.readings = with_scatter(std::move(averaged_));
    add_notes();
    return std::move(result_);
  }

 private:
  void find_levels() {
    const std::vector<double> noise_N = block_noise(blocks_);
    for (std::size_t part = 0; part < blocks_.size(); ++part) {
      for (const BlockStretch& level :
           steady_levels(blocks_[part], noise_N, options_.tolerance, width_s_)) {
        take(part, level);
      }
    }
  }

  void find_sliding() {
    std::vector<std::vector<double>> speeds;
    for (const std::vector<SeriesBlock>& blocks : blocks_) {
      speeds.push_back(block_speeds(blocks, result_.motion, width_s_));
      for (double& speed : speeds.back()) speed = options_.reverse ? -speed : speed;
    }
    SpeedScale scale = speed_scale(speeds);
    scale.has_sign |= result_.motion == MotionSource::position;
    std::vector<std::vector<BlockStretch>> stretches;
    for (std::size_t part = 0; part < blocks_.size(); ++part) {
      SlidingBlocks sliding = sliding_blocks(blocks_[part], speeds[part], scale, width_s_);
      for (std::size_t i = 0; i < sliding.uses.size(); ++i) mark(part, i, sliding.uses[i]);
      stretches.push_back(std::move(sliding.stretches));
    }
    const std::vector<RatioNoise> noise = forecast_noise(blocks_, stretches);
    for (std::size_t part = 0; part < blocks_.size(); ++part) {
      for (const BlockStretch& stretch : stretches[part]) take_settled(part, stretch, noise);
    }
  }

  void mark(std::size_t part, std::size_t block, SampleUse use) {
    const SeriesBlock& at = blocks_[part][block];
    std::fill(result_.uses.begin() + static_cast<std::ptrdiff_t>(at.begin),
              result_.uses.begin() + static_cast<std::ptrdiff_t>(at.end), use);
  }

  void take_settled(std::size_t part, const BlockStretch& stretch,
                    const std::vector<RatioNoise>& noise) {
    const std::vector<SeriesBlock>& blocks = blocks_[part];
    const auto [from, staying] = settled_part(blocks, stretch, noise, options_.tolerance);
    const SampleUse unsettled = staying.empty() ? SampleUse::settling : SampleUse::not_following;
    for (std::size_t i = stretch.begin; i < from; ++i) {
      mark(part, i, blocks[i].load_N > 0 ? unsettled : SampleUse::slack);
    }
    for (const std::size_t tension : staying) {
      staying_at_[tension].push_back(series_.lines[blocks[stretch.begin].begin]);
    }
    if (from < stretch.end) take(part, {from, stretch.end, stretch.direction});
  }

  // Relative change of the load from the first to the last third.
  double change_of_load(const std::vector<SeriesBlock>& blocks, const BlockStretch& stretch) const {
    const EndLevels load_N = end_levels(stretch.begin, stretch.end,
                                        [&](std::size_t block) { return blocks[block].load_N; });
    return (load_N.last - load_N.first) / std::abs(load_N.first);
  }

  std::optional<Direction> said_direction(std::size_t part) const {
    return read_direction(series_.labels[parts_.parts[part].label].direction);
  }

  // Sources, in this order: the log's own column, the motion, the load if the motion has no sign,
  // and the caller's option.
  std::optional<Direction> direction(std::size_t part, const BlockStretch& stretch) const {
    if (const auto said = said_direction(part)) return said;
    if (stretch.direction) return stretch.direction;
    if (result_.motion == MotionSource::speed) {
      const double change = change_of_load(blocks_[part], stretch);
      if (change > options_.tolerance) return Direction::pull;
      if (change < -options_.tolerance) return Direction::release;
    }
    return options_.direction;
  }

  std::size_t readings_of(std::size_t part, const BlockStretch& stretch) const {
    const std::size_t blocks = stretch.end - stretch.begin;
    if (result_.motion == MotionSource::none ||
        std::abs(change_of_load(blocks_[part], stretch)) <= sweep * options_.tolerance) {
      return 1;
    }
    return std::clamp<std::size_t>(blocks / blocks_per_min_duration, 1,
                                   options_.readings_per_stroke);
  }

  void take(std::size_t part, const BlockStretch& stretch) {
    const std::optional<Direction> way = direction(part, stretch);
    if (!way) {
      for (std::size_t i = stretch.begin; i < stretch.end; ++i) {
        mark(part, i, SampleUse::no_direction);
      }
      return;
    }
    const SeriesBlock& first_block = blocks_[part][stretch.begin];
    said_.add(series_.labels[parts_.parts[part].label].run, said_direction(part), stretch.direction,
              series_.lines[first_block.begin]);
    const std::size_t pieces = readings_of(part, stretch);
    const std::size_t blocks = stretch.end - stretch.begin;
    for (std::size_t piece = 0; piece < pieces; ++piece) {
      const std::size_t first = stretch.begin + piece * blocks / pieces;
      const std::size_t last = stretch.begin + (piece + 1) * blocks / pieces - 1;
      std::optional<AveragedStretch> averaged =
          average(series_, blocks_[part][first].begin, blocks_[part][last].end, options_.tolerance,
                  result_.uses);
      if (!averaged) continue;
      averaged->reading.label = parts_.parts[part].label;
      averaged->reading.direction = *way;
      averaged_.push_back(std::move(*averaged));
    }
  }

  void add_note(std::optional<DataNote> note) {
    if (note) result_.notes.push_back(std::move(*note));
  }

  void add_notes() {
    if (!parts_.clock_set_back.empty()) {
      result_.notes.push_back({NoteKind::clock,
                               "the clock goes back: the log is cut there, as where it was started "
                               "anew",
                               parts_.clock_set_back});
    }
    if (result_.motion == MotionSource::none) {
      result_.notes.push_back(
          {NoteKind::no_motion,
           "the log has no position, and no speed that says when the carriage moves: readings are "
           "steady levels of the tensions, and whether the tendon slides there is for you to know"});
    }
    note_missing_direction();
    note_staying_tensions();
    add_note(inverted_signals(series_));
    add_note(reversed_motion(result_.readings, options_.tolerance));
    add_note(said_.note());
    for (DataNote& note : sparse_channels(series_, result_.readings)) add_note(std::move(note));
  }

  void note_missing_direction() {
    const auto samples =
        std::count(result_.uses.begin(), result_.uses.end(), SampleUse::no_direction);
    if (samples == 0 || result_.motion != MotionSource::speed) return;
    result_.notes.push_back(
        {NoteKind::no_direction,
         fmt::format(
             "in {} samples the carriage moves, but the speed is nowhere below zero and the "
             "load stays, so that it may pull or release: no reading is made of them until "
             "a column 'direction' or whoever imports the log says which",
             samples)});
  }

  void note_staying_tensions() {
    for (const auto& [tension, lines] : staying_at_) {
      result_.notes.push_back(
          {NoteKind::not_following,
           fmt::format("{} stays while the load grows or falls, in stretches of the log of which "
                       "no reading is made: a contact sticks there, or the sensor's range ends, or "
                       "its zero is far off",
                       series_.tensions_N[tension].name),
           lines});
    }
  }

  const LoggedSeries& series_;
  const SteadyOptions& options_;
  Recordings parts_;
  std::vector<std::vector<SeriesBlock>> blocks_;  // [recording]
  double width_s_ = 0;
  std::map<std::size_t, std::vector<std::size_t>> staying_at_;  // tension → first lines
  SaidDirections said_;
  std::vector<AveragedStretch> averaged_;
  SteadyReadings result_;
};

}  // namespace

SteadyReadings steady_readings(const LoggedSeries& series, const SteadyOptions& options) {
  return SteadySearch(series, options).find();
}

}  // namespace reeve::readings
