// The routings of a file by the texts of its cells, each with the columns that are its segments.
#pragma once

#include <cstddef>
#include <functional>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "readings/channel_table.hpp"
#include "readings/measured_data.hpp"

namespace reeve::readings {

class RoutingTable {
 public:
  // `resolve` must outlive the table.
  RoutingTable(const std::vector<DataColumn>& columns, const RoutingResolver& resolve)
      : channels_(columns), resolve_(resolve) {}

  // Throws InputError of a text that is no routing, or of one that the motor cannot pull.
  std::size_t index(std::string_view text);
  std::size_t count() const { return routings_.size(); }
  const MeasuredRouting& operator[](std::size_t index) const { return routings_[index]; }
  const ChannelTable& channels() const { return channels_; }
  // Once all are known, since each may add channels.
  std::vector<MeasuredRouting> with_segments() const;

 private:
  std::size_t add(const Routing& routing);

  ChannelTable channels_;
  const RoutingResolver& resolve_;
  std::vector<MeasuredRouting> routings_;
  std::map<std::string, std::size_t, std::less<>> by_text_;
};

}  // namespace reeve::readings
