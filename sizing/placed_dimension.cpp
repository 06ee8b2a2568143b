#include "sizing/placed_dimension.hpp"

#include <algorithm>
#include <optional>
#include <utility>

#include "core/hand.hpp"
#include "core/mechanics.hpp"
#include "core/routing.hpp"

namespace reeve::sizing {
namespace {

struct AngledContact {
  Contact contact;
  PlacedDimension angle;
  bool is_own = false;  // the hardware gives the angle of this contact alone
};

// Without contacts whose angle the word gives: the hardware does not change these.
std::vector<AngledContact> angled_contacts(const Network& network, const Hardware& hardware) {
  const MechanicsBuilder builder(hardware);
  std::vector<AngledContact> result;
  for (const TendonSpan& tendon : network.tendons) {
    for (std::size_t k = 0; k < tendon.contacts; ++k) {
      if (network.contacts[tendon.first_contact + k].angle.is_given()) continue;
      const ContactHardware* own = builder.own_values(network, tendon, k);
      const ContactName name = own == nullptr ? name_at(network, tendon, k) : parse_contact(*own);
      result.push_back({network.contacts[tendon.first_contact + k],
                        {{SizedQuantity::contact_angle, 0, name.from, name.to},
                         builder.law_at(network, tendon, k).angle_rad},
                        own != nullptr && own->angle_rad});
    }
  }
  return result;
}

void sort_by_finger(std::vector<PlacedDimension>& found) {
  std::ranges::stable_sort(found, {}, [](const PlacedDimension& placed) {
    return placed.dimension.finger == 0 ? max_fingers + 1 : placed.dimension.finger;
  });
}

std::vector<PlacedDimension> angles_of_fingers(const Network& network, const Hardware& hardware,
                                               SizedQuantity quantity) {
  const bool sheaths = quantity == SizedQuantity::sheath_angle;
  const ContactPlace place = sheaths ? ContactPlace::sheath : ContactPlace::tip;
  std::vector<PlacedDimension> found;
  for (const auto& [contact, angle, is_own] : angled_contacts(network, hardware)) {
    if (contact.place != place || (contact.finger != 0 && is_own)) continue;
    PlacedDimension here = angle;
    if (contact.finger != 0) here.dimension = {quantity, contact.finger, {}, {}};
    const bool is_there = std::ranges::any_of(
        found, [&](const PlacedDimension& other) { return other.dimension == here.dimension; });
    if (!is_there) found.push_back(here);
  }
  sort_by_finger(found);
  return found;
}

std::vector<PlacedDimension> angles_of_contacts(const Network& network, const Hardware& hardware) {
  std::vector<PlacedDimension> found;
  for (const AngledContact& one : angled_contacts(network, hardware)) {
    if (one.contact.kind != ContactKind::bar) found.push_back(one.angle);
  }
  return found;
}

const FingerHardware* find_finger(const Hardware& hardware, int finger) {
  for (const FingerHardware& here : hardware.fingers) {
    if (here.finger == finger) return &here;
  }
  return nullptr;
}

std::vector<PlacedDimension> arms_of_fingers(const Network& network, const Hardware& hardware) {
  std::vector<PlacedDimension> found;
  for (int finger = 1; finger <= network.fingers; ++finger) {
    const FingerParts parts = finger_parts(hardware, finger);
    if (parts.joints.empty()) continue;
    found.push_back({{SizedQuantity::arm_mm, finger, {}, {}}, parts.joints.front().arm_mm});
  }
  return found;
}

std::vector<PlacedDimension> numbers_of_fingers(const Network& network, const Hardware& hardware,
                                                SizedQuantity quantity) {
  std::vector<PlacedDimension> found;
  if (quantity == SizedQuantity::closing && hand(hardware)) return found;
  for (int finger = 1; finger <= network.fingers; ++finger) {
    const FingerHardware* own = find_finger(hardware, finger);
    const double nominal = quantity == SizedQuantity::closing
                               ? (own != nullptr ? own->closing.value_or(1) : 1)
                           : own != nullptr ? own->strand_mm.value_or(hardware.strand_mm)
                                            : hardware.strand_mm;
    found.push_back({{quantity, finger, {}, {}}, nominal});
  }
  return found;
}

std::vector<PlacedDimension> lengths_of_hand(const Network& network, const Hardware& hardware,
                                             SizedQuantity quantity) {
  const bool motor = quantity == SizedQuantity::motor_side_mm;
  const SegmentKind kind = motor ? SegmentKind::motor_side : SegmentKind::hand;
  const bool there = std::ranges::any_of(
      network.segments, [&](const Segment& segment) { return segment.kind == kind; });
  if (!there) return {};
  return {{{quantity, 0, {}, {}}, motor ? hardware.motor_side_mm : hardware.hand_mm}};
}

FingerHardware& finger_of(Hardware& hardware, int finger) {
  for (FingerHardware& here : hardware.fingers) {
    if (here.finger == finger) return here;
  }
  // Keeps the order of the fingers, for a reader of the file.
  const auto place = std::ranges::find_if(
      hardware.fingers, [&](const FingerHardware& here) { return here.finger > finger; });
  FingerHardware& added = *hardware.fingers.emplace(place);
  added.finger = finger;
  return added;
}

ContactHardware& contact_of(Hardware& hardware, const SizedDimension& dimension) {
  for (ContactHardware& here : hardware.contacts) {
    if (parse_contact(here) == dimension.contact()) return here;
  }
  hardware.contacts.push_back(
      {segment_name(dimension.from), segment_name(dimension.to), std::nullopt, std::nullopt});
  return hardware.contacts.back();
}

void set_arm(Hardware& hardware, int finger, double value) {
  std::vector<FingerJoint> joints = finger_parts(hardware, finger).joints;
  const double factor = value / joints.front().arm_mm;
  for (FingerJoint& joint : joints) joint.arm_mm *= factor;
  finger_of(hardware, finger).parts.joints = std::move(joints);
}

}  // namespace

std::vector<PlacedDimension> dimensions_of(const Network& network, const Hardware& hardware,
                                           SizedQuantity quantity) {
  switch (quantity) {
    case SizedQuantity::sheath_angle:
    case SizedQuantity::tip_angle:
      return angles_of_fingers(network, hardware, quantity);
    case SizedQuantity::contact_angle:
      return angles_of_contacts(network, hardware);
    case SizedQuantity::strand_mm:
    case SizedQuantity::closing:
      return numbers_of_fingers(network, hardware, quantity);
    case SizedQuantity::arm_mm:
      return arms_of_fingers(network, hardware);
    case SizedQuantity::motor_side_mm:
    case SizedQuantity::hand_mm:
      return lengths_of_hand(network, hardware, quantity);
  }
  return {};
}

void set(Hardware& hardware, const SizedDimension& dimension, double value) {
  switch (dimension.quantity) {
    case SizedQuantity::sheath_angle:
      finger_of(hardware, dimension.finger).sheath_angle_rad = value;
      break;
    case SizedQuantity::tip_angle:
      finger_of(hardware, dimension.finger).tip_angle_rad = value;
      break;
    case SizedQuantity::strand_mm:
      finger_of(hardware, dimension.finger).strand_mm = value;
      break;
    case SizedQuantity::closing:
      finger_of(hardware, dimension.finger).closing = value;
      break;
    case SizedQuantity::arm_mm:
      set_arm(hardware, dimension.finger, value);
      break;
    case SizedQuantity::contact_angle:
      contact_of(hardware, dimension).angle_rad = value;
      break;
    case SizedQuantity::motor_side_mm:
      hardware.motor_side_mm = value;
      break;
    case SizedQuantity::hand_mm:
      hardware.hand_mm = value;
      break;
  }
}

}  // namespace reeve::sizing
