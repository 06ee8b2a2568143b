#include "readings/routing_table.hpp"

#include <utility>

#include "core/error.hpp"
#include "core/graph.hpp"
#include "core/notation.hpp"

namespace reeve::readings {

std::size_t RoutingTable::index(std::string_view text) {
  const auto found = by_text_.find(text);
  if (found != by_text_.end()) return found->second;
  if (text.empty()) throw InputError({.expected = "a routing such as M-1-T-2-F"});
  const std::size_t index = add(resolve_(std::string(text)));
  by_text_.emplace(text, index);
  return index;
}

// A name and its word are one routing.
std::size_t RoutingTable::add(const Routing& routing) {
  for (std::size_t i = 0; i < routings_.size(); ++i) {
    if (routings_[i].routing == routing) return i;
  }
  MeasuredRouting measured{to_word(routing), routing, expand(routing), {}};
  require_actuated(graph(measured.network), measured.word);
  channels_.add_routing(measured.network);
  routings_.push_back(std::move(measured));
  return routings_.size() - 1;
}

std::vector<MeasuredRouting> RoutingTable::with_segments() const {
  std::vector<MeasuredRouting> result = routings_;
  for (MeasuredRouting& routing : result) {
    for (const Channel& channel : channels_.channels()) {
      routing.segments.push_back(find_segment(routing.network, channel.segment));
    }
  }
  return result;
}

}  // namespace reeve::readings
