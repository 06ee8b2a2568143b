#include "core/tension/seizure.hpp"

#include <algorithm>
#include <numeric>

namespace reeve::core {
namespace {

template <typename T>
void rotate_part(std::vector<T>& values, std::size_t first, std::size_t count, std::size_t by) {
  const auto begin = values.begin() + static_cast<std::ptrdiff_t>(first);
  std::rotate(begin, begin + static_cast<std::ptrdiff_t>(by),
              begin + static_cast<std::ptrdiff_t>(count));
}

// On a block's sheave the tendon is then tied to the block on both sides, as with a becket.
TendonEnd end_at(const Network& network, std::size_t contact) {
  const std::size_t block = network.contacts[contact].block;
  if (block == no_block) return {};
  return {EndTie::becket, block};
}

// Behind the seized contact the loop begins anew.
void open_loop(SeizedNetwork& seized, TendonSpan& tendon, std::size_t k) {
  tendon.left = tendon.right = end_at(seized.network, tendon.first_contact + k);
  const std::size_t by = (k + 1) % tendon.segments;
  rotate_part(seized.network.segments, tendon.first_segment, tendon.segments, by);
  rotate_part(seized.segment_from, tendon.first_segment, tendon.segments, by);
  rotate_part(seized.network.contacts, tendon.first_contact, tendon.contacts, by);
  rotate_part(seized.contact_from, tendon.first_contact, tendon.contacts, by);
  tendon.closed = false;
  tendon.contacts -= 1;
}

void cut(Network& network, std::size_t t, std::size_t k) {
  std::vector<TendonSpan>& tendons = network.tendons;
  const TendonSpan whole = tendons[t];
  const TendonEnd end = end_at(network, whole.first_contact + k);
  const TendonSpan head{whole.first_segment, k + 1, whole.first_contact, k, false, whole.left, end};
  const TendonSpan tail{whole.first_segment + k + 1,
                        whole.segments - k - 1,
                        whole.first_contact + k + 1,
                        whole.contacts - k - 1,
                        false,
                        end,
                        whole.right};
  tendons[t] = head;
  tendons.insert(tendons.begin() + static_cast<std::ptrdiff_t>(t) + 1, tail);
}

void seize_one(SeizedNetwork& seized, std::size_t contact) {
  const auto found = std::find(seized.contact_from.begin(), seized.contact_from.end(), contact);
  const auto at = static_cast<std::size_t>(found - seized.contact_from.begin());
  std::vector<TendonSpan>& tendons = seized.network.tendons;
  for (std::size_t t = 0; t < tendons.size(); ++t) {
    if (at < tendons[t].first_contact || at >= tendons[t].first_contact + tendons[t].contacts) {
      continue;
    }
    const std::size_t k = at - tendons[t].first_contact;
    if (tendons[t].closed) {
      open_loop(seized, tendons[t], k);
    } else {
      cut(seized.network, t, k);
    }
    return;
  }
}

template <typename T>
std::vector<T> scattered(const std::vector<T>& values, const std::vector<std::size_t>& from) {
  std::vector<T> result(values.size());
  for (std::size_t i = 0; i < values.size(); ++i) result[from[i]] = values[i];
  return result;
}

}  // namespace

SeizedNetwork seize(const Network& network, const std::vector<std::size_t>& contacts) {
  SeizedNetwork seized{network, std::vector<std::size_t>(network.segments.size()),
                       std::vector<std::size_t>(network.contacts.size())};
  std::iota(seized.segment_from.begin(), seized.segment_from.end(), std::size_t{0});
  std::iota(seized.contact_from.begin(), seized.contact_from.end(), std::size_t{0});
  seized.network.split = true;
  for (const std::size_t contact : contacts) seize_one(seized, contact);
  number_trees(seized.network);
  return seized;
}

TensionState restored(const SeizedNetwork& seized, const TensionState& state) {
  TensionState result = state;
  result.tension = scattered(state.tension, seized.segment_from);
  result.slip = scattered(state.slip, seized.contact_from);
  return result;
}

}  // namespace reeve::core
