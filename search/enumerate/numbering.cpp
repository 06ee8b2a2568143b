#include "search/enumerate/numbering.hpp"

#include <algorithm>
#include <utility>

#include "core/notation.hpp"

namespace reeve::search {
namespace {

std::uint64_t bit(int finger) { return std::uint64_t{1} << (finger - 1); }

int first_finger(const Tendon& tendon) {
  return std::find_if(tendon.walk.begin(), tendon.walk.end(),
                      [](const Token& token) { return is_of_finger(token.kind); })
      ->finger;
}

}  // namespace

void number_in_order(Routing& routing) {
  std::uint8_t next = 1;
  for (Tendon& tendon : routing.tendons) {
    for (Token& token : tendon.walk) {
      if (is_of_finger(token.kind)) token.finger = next++;
    }
  }
}

void Numbering::start(Routing& routing) {
  places_.clear();
  used_ = 0;
  for (std::size_t t = 0; t < routing.tendons.size(); ++t) {
    const Walk& walk = routing.tendons[t].walk;
    bool opens_twin = t > 0 && same_shape(routing.tendons[t - 1], routing.tendons[t]);
    for (std::size_t i = 0; i < walk.size(); ++i) {
      if (!is_of_finger(walk[i].kind)) continue;
      places_.push_back({t, i, opens_twin, false});
      opens_twin = false;
    }
    places_.back().ends_tendon = true;
  }
  advance(routing, 0, 1);
}

bool Numbering::next(Routing& routing) {
  const Place& last = places_.back();
  const int finger = routing.tendons[last.tendon].walk[last.token].finger;
  used_ &= ~bit(finger);
  return advance(routing, places_.size() - 1, finger + 1);
}

// Backtracking from `place`, which takes fingers from `from` on; the places before it hold theirs.
bool Numbering::advance(Routing& routing, std::size_t place, int from) {
  const int fingers = static_cast<int>(places_.size());
  while (true) {
    Token& token = routing.tendons[places_[place].tendon].walk[places_[place].token];
    int finger = from;
    for (; finger <= fingers; ++finger) {
      if ((used_ & bit(finger)) != 0) continue;
      token.finger = static_cast<std::uint8_t>(finger);
      if (admits(routing, places_[place])) break;
    }
    if (finger <= fingers) {
      used_ |= bit(finger);
      if (++place == places_.size()) return true;
      from = 1;
    } else {
      if (place-- == 0) return false;
      const Place& before = places_[place];
      from = routing.tendons[before.tendon].walk[before.token].finger + 1;
      used_ &= ~bit(from - 1);
    }
  }
}

bool Numbering::admits(const Routing& routing, const Place& place) const {
  const Tendon& tendon = routing.tendons[place.tendon];
  if (place.opens_twin &&
      tendon.walk[place.token].finger < first_finger(routing.tendons[place.tendon - 1])) {
    return false;
  }
  return !place.ends_tendon || is_canonical(tendon);
}

void CarriageNumbering::start(const Routing& of_one_motor) {
  routing_ = of_one_motor;
  numbers_.clear();
  given_.clear();
  at_first_ = true;
  for (Tendon& tendon : routing_.tendons) {
    for (Token& token : tendon.walk) {
      if (is_on_carriage(token.kind)) numbers_.push_back(&token.carriage);
    }
  }
  if (numbers_.size() < static_cast<std::size_t>(motors_)) numbers_.clear();
}

// Names of identical motors make no difference, so each new one may have the next number.
bool CarriageNumbering::advance() {
  const auto greatest_before = [&](std::size_t place) {
    std::uint8_t greatest = 0;
    for (std::size_t i = 0; i < place; ++i) greatest = std::max(greatest, *numbers_[i]);
    return greatest;
  };
  for (std::size_t place = numbers_.size(); place-- > 0;) {
    const bool alike = identity_ == FingerIdentity::identical;
    const int most = alike ? std::min(motors_, greatest_before(place) + 1) : motors_;
    if (*numbers_[place] < most) {
      ++*numbers_[place];
      return true;
    }
    *numbers_[place] = 1;
  }
  return false;
}

bool CarriageNumbering::uses_all() const {
  for (int motor = 1; motor <= motors_; ++motor) {
    if (std::none_of(numbers_.begin(), numbers_.end(),
                     [&](const std::uint8_t* number) { return *number == motor; })) {
      return false;
    }
  }
  return true;
}

bool CarriageNumbering::next(Routing& routing) {
  while (!numbers_.empty() && (std::exchange(at_first_, false) || advance())) {
    if (!uses_all()) continue;
    routing = canonical(routing_, identity_);
    if (given_.insert(to_word(routing)).second) return true;
  }
  numbers_.clear();
  return false;
}

}  // namespace reeve::search
