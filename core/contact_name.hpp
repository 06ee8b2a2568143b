// The name of one contact: the two segments that it joins, in walk order, such as T1-T2.
//
// If no other contact joins these two, the other order means it, too. In a loop of two segments
// (1-T-1) two contacts do, and each order names one of them: every walk passes the fingertip from
// T1 to T2 and the join from T2 to T1.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/network.hpp"

namespace reeve::core {

struct ContactName {
  Segment from;
  Segment to;

  friend bool operator==(const ContactName&, const ContactName&) = default;
};

std::string to_text(const ContactName& name);
// The reverse; nothing of what is no such name.
std::optional<ContactName> contact_named(std::string_view text);

// The name of the tendon's k-th contact, in walk order.
ContactName name_at(const Network& network, const TendonSpan& tendon, std::size_t k);
// True if the name means the tendon's k-th contact.
bool means(const ContactName& name, const Network& network, const TendonSpan& tendon,
           std::size_t k);
// True if the two names mean one contact in every routing that has it.
bool mean_the_same(const ContactName& a, const ContactName& b);

// "T1-T2", in walk order.
std::string contact_name(const Network& network, std::size_t contact);
// The contact that the name means, if the network has it.
std::optional<std::size_t> find_contact(const Network& network, const ContactName& name);
std::optional<std::size_t> find_contact(const Network& network, std::string_view name);

// Returns the item that names the tendon's k-th contact, and of two that do the one in walk order;
// nullptr if there is none. `name_of` gives the name of an item.
template <typename Item, typename NameOf>
const Item* find_by_contact(const std::vector<Item>& items, const Network& network,
                            const TendonSpan& tendon, std::size_t k, NameOf name_of) {
  const Item* found = nullptr;
  for (const Item& item : items) {
    const ContactName& name = name_of(item);
    if (!means(name, network, tendon, k)) continue;
    if (name == name_at(network, tendon, k)) return &item;
    found = &item;
  }
  return found;
}

}  // namespace reeve::core
