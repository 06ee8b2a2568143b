// Which columns are channels. A column of a strand or of a lettered segment is one. A column at_T1
// is of the motor-side segment that is beside T1, so its letter, and with it its channel, is a
// matter of each routing.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "readings/data_columns.hpp"
#include "readings/measured_data.hpp"

namespace reeve::readings {

class ChannelTable {
 public:
  explicit ChannelTable(const std::vector<DataColumn>& columns);

  // Adds the channels that columns beside strands are for this routing, the next one.
  void add_routing(const Network& network);

  // Of a column of tensions or of deviations; nothing if the routing has no such segment.
  std::optional<std::size_t> channel(std::size_t routing, std::size_t column) const {
    return of_routing_[routing][column];
  }
  const std::vector<Channel>& channels() const { return channels_; }

 private:
  std::size_t channel_of(const Segment& segment);

  std::vector<MeasuredPlace> places_;  // by column
  std::vector<bool> measured_;         // whether it is such a column
  std::vector<Channel> channels_;
  std::vector<std::vector<std::optional<std::size_t>>> of_routing_;
};

}  // namespace reeve::readings
