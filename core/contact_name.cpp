#include "core/contact_name.hpp"

namespace reeve::core {
namespace {

ContactName reversed(const ContactName& name) { return {name.to, name.from}; }

// True if two contacts of the tendon join the same two segments.
bool joins_twice(const TendonSpan& tendon) { return tendon.closed && tendon.segments == 2; }

bool are_of_one_finger(const ContactName& name) {
  return name.from.finger != 0 && name.from.finger == name.to.finger;
}

}  // namespace

std::string to_text(const ContactName& name) {
  return segment_name(name.from) + "-" + segment_name(name.to);
}

std::optional<ContactName> contact_named(std::string_view text) {
  const std::size_t dash = text.find('-');
  if (dash == std::string_view::npos) return std::nullopt;
  const auto from = segment_named(text.substr(0, dash));
  const auto to = segment_named(text.substr(dash + 1));
  if (!from || !to) return std::nullopt;
  return ContactName{*from, *to};
}

ContactName name_at(const Network& network, const TendonSpan& tendon, std::size_t k) {
  const auto [left, right] = ends_of(tendon, k);
  return {network.segments[left], network.segments[right]};
}

bool means(const ContactName& name, const Network& network, const TendonSpan& tendon,
           std::size_t k) {
  const ContactName in_walk_order = name_at(network, tendon, k);
  return name == in_walk_order || (!joins_twice(tendon) && reversed(name) == in_walk_order);
}

// The two contacts of a loop of two segments join the strands of its finger.
bool mean_the_same(const ContactName& a, const ContactName& b) {
  return a == b || (a == reversed(b) && !are_of_one_finger(a));
}

std::string contact_name(const Network& network, std::size_t contact) {
  for (const TendonSpan& tendon : network.tendons) {
    if (contact < tendon.first_contact || contact >= tendon.first_contact + tendon.contacts) {
      continue;
    }
    return to_text(name_at(network, tendon, contact - tendon.first_contact));
  }
  return {};
}

std::optional<std::size_t> find_contact(const Network& network, const ContactName& name) {
  for (const TendonSpan& tendon : network.tendons) {
    for (std::size_t k = 0; k < tendon.contacts; ++k) {
      if (means(name, network, tendon, k)) return tendon.first_contact + k;
    }
  }
  return std::nullopt;
}

std::optional<std::size_t> find_contact(const Network& network, std::string_view text) {
  const auto name = contact_named(text);
  return name ? find_contact(network, *name) : std::nullopt;
}

}  // namespace reeve::core
