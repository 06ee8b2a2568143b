#include "readings/channel_table.hpp"

#include <algorithm>

#include "core/motor_sides.hpp"

namespace reeve::readings {

ChannelTable::ChannelTable(const std::vector<DataColumn>& columns) {
  for (const DataColumn& column : columns) {
    places_.push_back(column.place);
    measured_.push_back(column.role == DataRole::tension || column.role == DataRole::deviation);
    if (column.role == DataRole::tension && !column.place.beside) channel_of(column.place.segment);
  }
}

void ChannelTable::add_routing(const Network& network) {
  std::vector<std::optional<std::size_t>> channels(places_.size());
  for (std::size_t column = 0; column < places_.size(); ++column) {
    if (!measured_[column]) continue;
    const MeasuredPlace& place = places_[column];
    const auto segment = place.beside ? motor_side_at(network, place.segment) : place.segment;
    if (segment && find_segment(network, *segment)) channels[column] = channel_of(*segment);
  }
  of_routing_.push_back(std::move(channels));
}

std::size_t ChannelTable::channel_of(const Segment& segment) {
  const auto found = std::find_if(channels_.begin(), channels_.end(), [&](const Channel& channel) {
    return channel.segment == segment;
  });
  if (found != channels_.end()) return static_cast<std::size_t>(found - channels_.begin());
  channels_.push_back({segment_name(segment), segment});
  return channels_.size() - 1;
}

}  // namespace reeve::readings
