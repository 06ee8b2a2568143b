#include "readings/measured_shares.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace reeve::readings {
namespace {

// T1 … T2n of a reading over their sum; empty if one is missing, or if all are slack.
std::vector<double> shares(const MeasuredData& data, const Reading& reading) {
  std::vector<double> result = strand_tensions(data, reading).value_or(std::vector<double>{});
  const double sum = std::accumulate(result.begin(), result.end(), 0.0);
  if (!(sum > 0)) return {};
  for (double& share : result) share /= sum;
  return result;
}

struct ShareGroup {
  MeasuredShares shares;
  std::vector<std::vector<double>> readings;
};

MeasuredShares summary(ShareGroup group) {
  MeasuredShares result = std::move(group.shares);
  result.readings = group.readings.size();
  const auto n = static_cast<double>(result.readings);
  for (std::size_t i = 0; i < group.readings.front().size(); ++i) {
    double sum = 0;
    for (const auto& reading : group.readings) sum += reading[i];
    result.mean.push_back(sum / n);
    if (result.readings < 2) continue;
    double squares = 0;
    for (const auto& reading : group.readings) squares += std::pow(reading[i] - sum / n, 2);
    result.deviation.push_back(std::sqrt(squares / (n - 1)));
  }
  return result;
}

ShareGroup& group_of(std::vector<ShareGroup>& groups, const Reading& reading) {
  const auto found = std::find_if(groups.begin(), groups.end(), [&](const ShareGroup& group) {
    return group.shares.routing == reading.routing && group.shares.grasp == reading.grasp;
  });
  if (found != groups.end()) return *found;
  groups.push_back({{reading.routing, reading.grasp, 0, {}, {}}, {}});
  return groups.back();
}

}  // namespace

std::vector<std::size_t> strand_channels(const MeasuredData& data, const MeasuredRouting& routing) {
  std::vector<std::size_t> channels;
  for (int strand = 1; strand <= 2 * routing.network.fingers; ++strand) {
    const Segment wanted{SegmentKind::strand, strand, 0};
    if (!find_segment(routing.network, wanted)) continue;
    const auto found =
        std::find_if(data.channels.begin(), data.channels.end(),
                     [&](const Channel& channel) { return channel.segment == wanted; });
    if (found == data.channels.end()) return {};
    channels.push_back(static_cast<std::size_t>(found - data.channels.begin()));
  }
  return channels;
}

std::optional<std::vector<double>> strand_tensions(const MeasuredData& data,
                                                   const Reading& reading) {
  const auto channels = strand_channels(data, data.routings[reading.routing]);
  if (channels.empty()) return std::nullopt;
  std::vector<double> tensions;
  for (const std::size_t c : channels) {
    if (!reading.tension_N[c]) return std::nullopt;
    tensions.push_back(*reading.tension_N[c]);
  }
  return tensions;
}

SharesOfData measured_shares(const MeasuredData& data) {
  DataNote released{NoteKind::not_compared, "readings of releasing are left out", {}};
  DataNote without{NoteKind::not_compared,
                   "a share needs the tensions of all strands, not all of them slack: these "
                   "readings are left out"};
  std::vector<ShareGroup> groups;
  for (const Reading& reading : data.readings) {
    std::vector<double> strands = shares(data, reading);
    if (reading.direction != Direction::pull) {
      released.lines.push_back(reading.line);
    } else if (strands.empty()) {
      without.lines.push_back(reading.line);
    } else {
      group_of(groups, reading).readings.push_back(std::move(strands));
    }
  }
  SharesOfData result;
  for (ShareGroup& group : groups) result.groups.push_back(summary(std::move(group)));
  for (DataNote* note : {&released, &without}) {
    if (!note->lines.empty()) result.notes.push_back(std::move(*note));
  }
  return result;
}

}  // namespace reeve::readings
