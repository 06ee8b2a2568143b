#include "sizing/size_space.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "core/error.hpp"
#include "core/hand.hpp"
#include "core/notation.hpp"

namespace reeve::sizing {
namespace {

bool means_in(const Network& network, const SizedDimension& named, const SizedDimension& placed) {
  if (row(placed.quantity).of != QuantityOf::contact) return named == placed;
  return named.quantity == placed.quantity &&
         find_contact(network, named.contact()) == find_contact(network, placed.contact());
}

std::vector<PlacedDimension> covered(const Network& network, const Hardware& hardware,
                                     const DimensionName& name) {
  std::vector<PlacedDimension> found;
  for (const PlacedDimension& placed : dimensions_of(network, hardware, name.quantity)) {
    const bool is_named = std::ranges::any_of(name.named, [&](const SizedDimension& named) {
      return means_in(network, named, placed.dimension);
    });
    if (name.named.empty() || is_named) found.push_back(placed);
  }
  return found;
}

// "tip_angle[1,2]" of fingers, otherwise each by itself.
std::string joint_name(const std::vector<PlacedDimension>& dimensions,
                       const std::vector<std::size_t>& members) {
  std::string fingers;
  std::string others;
  const SizedQuantity quantity = dimensions[members.front()].dimension.quantity;
  for (const std::size_t i : members) {
    const SizedDimension& one = dimensions[i].dimension;
    if (one.quantity == quantity && one.finger > 0) {
      fingers += (fingers.empty() ? "" : ",") + std::to_string(one.finger);
    } else {
      others += (others.empty() ? "" : "=") + to_text(one);
    }
  }
  if (fingers.empty()) return others;
  return fmt::format("{}[{}]{}{}", row(quantity).name, fingers, others.empty() ? "" : "=", others);
}

class Collector {
 public:
  Collector(const Network& network, const Hardware& hardware)
      : network_(network), hardware_(hardware) {}

  void add(const VariedRange& range) {
    for (const PlacedDimension& placed : covered(network_, hardware_, range.name)) {
      const std::size_t at = place_of(placed);
      if (at < space_.dimensions.size()) {
        bounds_[at] = range.bounds;
      } else {
        space_.dimensions.push_back(placed);
        bounds_.push_back(range.bounds);
      }
    }
  }

  void join(const EqualGroup& group) {
    std::vector<std::size_t> members;
    for (const PlacedDimension& placed : covered(network_, hardware_, group.name)) {
      const std::size_t at = place_of(placed);
      if (at < space_.dimensions.size()) members.push_back(at);
    }
    if (!members.empty()) add_joint({members, group.text});
  }

  SizeSpace finish() {
    std::vector<bool> taken(space_.dimensions.size(), false);
    for (std::size_t i = 0; i < space_.dimensions.size(); ++i) {
      if (taken[i]) continue;
      const Joint joint = joint_of(i);
      for (const std::size_t member : joint.members) taken[member] = true;
      space_.variables.push_back(variable(joint));
    }
    return std::move(space_);
  }

 private:
  struct Joint {
    std::vector<std::size_t> members;
    std::string text;
  };

  std::size_t place_of(const PlacedDimension& placed) const {
    const auto found =
        std::ranges::find(space_.dimensions, placed.dimension, &PlacedDimension::dimension);
    return static_cast<std::size_t>(found - space_.dimensions.begin());
  }

  // Merges groups that overlap: equality is transitive.
  void add_joint(Joint joint) {
    std::vector<Joint> apart;
    for (Joint& other : groups_) {
      const bool overlaps = std::ranges::any_of(other.members, [&](std::size_t member) {
        return std::ranges::count(joint.members, member) > 0;
      });
      if (overlaps) {
        joint.members.insert(joint.members.end(), other.members.begin(), other.members.end());
      } else {
        apart.push_back(std::move(other));
      }
    }
    std::sort(joint.members.begin(), joint.members.end());
    joint.members.erase(std::unique(joint.members.begin(), joint.members.end()),
                        joint.members.end());
    groups_ = std::move(apart);
    groups_.push_back(std::move(joint));
  }

  Joint joint_of(std::size_t dimension) const {
    for (const Joint& group : groups_) {
      if (std::ranges::count(group.members, dimension) > 0) return group;
    }
    return {{dimension}, ""};
  }

  SizeVariable variable(const Joint& joint) const {
    SizeVariable result;
    result.name = joint_name(space_.dimensions, joint.members);
    result.unit = row(space_.dimensions[joint.members.front()].dimension.quantity).unit;
    result.dimensions = joint.members;
    result.bounds = bounds_[joint.members.front()];
    for (const std::size_t member : joint.members) {
      result.bounds.low = std::max(result.bounds.low, bounds_[member].low);
      result.bounds.high = std::min(result.bounds.high, bounds_[member].high);
      result.nominal += space_.dimensions[member].nominal;
    }
    result.nominal /= static_cast<double>(joint.members.size());
    if (result.bounds.low > result.bounds.high) {
      throw InputError({.what = joint.text,
                        .expected = fmt::format("bounds that {} have in common", result.name)});
    }
    return result;
  }

  const Network& network_;
  const Hardware& hardware_;
  SizeSpace space_;
  std::vector<Interval> bounds_;
  std::vector<Joint> groups_;
};

// In some network.
bool says_again(const DimensionName& a, const DimensionName& b,
                const std::vector<Network>& networks) {
  if (a.quantity != b.quantity || a.named.empty() != b.named.empty()) return false;
  if (a.named.empty()) return true;
  const auto is_again = [&](const SizedDimension& one) {
    if (b.has(one)) return true;
    return std::ranges::any_of(b.named, [&](const SizedDimension& other) {
      return std::ranges::any_of(networks, [&](const Network& network) {
        return find_contact(network, one.contact()) && means_in(network, one, other);
      });
    });
  };
  return std::ranges::any_of(a.named, is_again);
}

// Lists the dimensions of a routing that could be varied.
std::string dimension_list(const Network& network, const Hardware& hardware) {
  constexpr std::size_t most = 12;
  std::vector<std::string> names;
  for (const QuantityRow& row : quantity_table()) {
    for (const PlacedDimension& placed : dimensions_of(network, hardware, row.quantity)) {
      const std::string name = to_text(placed.dimension);
      if (std::ranges::find(names, name) == names.end()) names.push_back(name);
    }
  }
  const bool has_more = names.size() > most;
  if (has_more) names.resize(most);
  return fmt::format("{}{}", fmt::join(names, ", "), has_more ? ", …" : "");
}

// Returns what a quantity needs that no routing has by itself; empty if nothing such is missing.
const char* needs(SizedQuantity quantity, const Hardware& hardware) {
  if (quantity != SizedQuantity::arm_mm || hand(hardware)) return "";
  return "a hand with it: the joints of its fingers in the hardware file (docs/hand.md)";
}

// Each named dimension must be so in some routing; without names, one of the quantity.
template <typename IsSo>
bool is_somewhere(const DimensionName& name, const std::vector<Network>& networks, IsSo is_so) {
  const auto has = [&](const DimensionName& one) {
    return std::ranges::any_of(networks,
                               [&](const Network& network) { return is_so(network, one); });
  };
  if (name.named.empty()) return has(name);
  return std::ranges::all_of(name.named, [&](const SizedDimension& dimension) {
    return has({name.quantity, {dimension}});
  });
}

void require_once(const std::vector<VariedRange>& ranges, const std::vector<Network>& networks) {
  for (std::size_t i = 0; i < ranges.size(); ++i) {
    for (std::size_t k = 0; k < i; ++k) {
      if (!says_again(ranges[i].name, ranges[k].name, networks)) continue;
      throw InputError({.where = ranges[i].text,
                        .what = fmt::format("what {} varies is varied again", ranges[k].text)});
    }
  }
}

// A contact's own angle hides that of its finger.
void require_none_hidden(const Network& network, const Hardware& hardware, const SizeSpace& space) {
  Hardware with_contacts = hardware;
  for (const PlacedDimension& placed : space.dimensions) {
    if (placed.dimension.quantity == SizedQuantity::contact_angle) {
      set(with_contacts, placed.dimension, placed.nominal);
    }
  }
  for (const PlacedDimension& placed : space.dimensions) {
    const auto left = dimensions_of(network, with_contacts, placed.dimension.quantity);
    const bool is_left = std::ranges::any_of(
        left, [&](const PlacedDimension& one) { return one.dimension == placed.dimension; });
    if (is_left) continue;
    throw InputError({.what = "varied dimension",
                      .value = to_text(placed.dimension),
                      .expected = "no contact_angle of the same contacts beside it"});
  }
}

}  // namespace

SizeSpace size_space(const Network& network, const Hardware& hardware,
                     const std::vector<VariedRange>& ranges, const std::vector<EqualGroup>& equal) {
  Collector collector(network, hardware);
  for (const VariedRange& range : ranges) {
    if (range.name.named.empty()) collector.add(range);
  }
  for (const VariedRange& range : ranges) {
    if (!range.name.named.empty()) collector.add(range);
  }
  for (const EqualGroup& group : equal) collector.join(group);
  return collector.finish();
}

void require_ranges_to_match(const std::vector<Routing>& routings, const Hardware& hardware,
                             const std::vector<VariedRange>& ranges,
                             const std::vector<EqualGroup>& equal) {
  std::vector<Network> networks;
  for (const Routing& routing : routings) networks.push_back(expand(routing));
  require_once(ranges, networks);
  const std::string there = fmt::format(
      "dimensions of {}{}: {}", routings.size() > 1 ? "one of the routings, such as those of " : "",
      to_word(routings.front()), dimension_list(networks.front(), hardware));
  const auto is_there = [&](const Network& network, const DimensionName& name) {
    return !covered(network, hardware, name).empty();
  };
  for (const VariedRange& range : ranges) {
    if (!is_somewhere(range.name, networks, is_there)) {
      const std::string needed = needs(range.name.quantity, hardware);
      throw InputError({.what = range.text, .expected = needed.empty() ? there : needed});
    }
  }
  for (const Network& network : networks) {
    require_none_hidden(network, hardware, size_space(network, hardware, ranges, equal));
  }
  const auto is_varied = [&](const Network& network, const DimensionName& name) {
    const SizeSpace space = size_space(network, hardware, ranges, {});
    return std::ranges::any_of(covered(network, hardware, name), [&](const PlacedDimension& one) {
      return std::ranges::find(space.dimensions, one.dimension, &PlacedDimension::dimension) !=
             space.dimensions.end();
    });
  };
  for (const EqualGroup& group : equal) {
    if (!is_somewhere(group.name, networks, is_varied))
      throw InputError({.what = group.text, .expected = "dimensions that are varied"});
  }
}

}  // namespace reeve::sizing
