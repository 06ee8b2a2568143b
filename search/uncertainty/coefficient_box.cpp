#include "search/uncertainty/coefficient_box.hpp"

#include <algorithm>

#include "core/routing.hpp"
#include "numerics/random.hpp"

namespace reeve::search {
namespace {

Interval around(double value, double relative) {
  return {value * (1 - relative), value * (1 + relative)};
}

// Widens a literature range to include the value of the user's hardware, if it was not measured.
Interval range_of(const ContactLaw& law, const MuRange& literature) {
  if (law.known) return {law.mu, law.mu};
  return {std::min(literature.low, law.mu), std::max(literature.high, law.mu)};
}

// Returns the μ on which the interval of the bearings is centred. If bearings have no friction,
// this is the block's μ, so that the block varies.
double bearing_reference(const Hardware& nominal) {
  return nominal.bearing.mu == 0 && nominal.block ? nominal.block->mu : nominal.bearing.mu;
}

bool is_of_sheath(const ContactHardware& contact) {
  const auto is_motor_side = [](const std::string& segment) {
    return parse_segment(segment).kind == SegmentKind::motor_side;
  };
  return is_motor_side(contact.segment) || is_motor_side(contact.other_segment);
}

void bend_sheaths(Hardware& hardware, double factor) {
  hardware.sheath.angle_rad *= factor;
  for (FingerHardware& finger : hardware.fingers) {
    if (finger.sheath_angle_rad) *finger.sheath_angle_rad *= factor;
  }
  for (ContactHardware& contact : hardware.contacts) {
    if (contact.angle_rad && is_of_sheath(contact)) *contact.angle_rad *= factor;
  }
}

}  // namespace

CoefficientBox coefficient_box(const Hardware& nominal, const UncertaintyRanges& ranges) {
  const double of_bearings = nominal.bearing.known ? 0 : ranges.bearing_mu_relative;
  return {range_of(nominal.tube, ranges.tube_mu), range_of(nominal.sheath, ranges.sheath_mu),
          around(bearing_reference(nominal), of_bearings),
          around(nominal.sheath.angle_rad, ranges.sheath_angle_relative)};
}

std::vector<double> drawn_point(const CoefficientBox& box, std::uint64_t seed, std::uint64_t draw) {
  std::vector<double> point;
  for (const Interval& interval : box) {
    const double share = uniform(seed, static_cast<std::uint32_t>(point.size()), draw);
    point.push_back(interval.low + (interval.high - interval.low) * share);
  }
  return point;
}

std::optional<ContactDraw> contact_draw(const Hardware& hardware, std::uint64_t seed,
                                        std::uint64_t draw) {
  if (hardware.scatter == ContactScatter{0, 0}) return std::nullopt;
  return ContactDraw{seed, draw};
}

std::vector<double> point_of(const Hardware& hardware) {
  return {hardware.tube.mu, hardware.sheath.mu, bearing_reference(hardware),
          hardware.sheath.angle_rad};
}

Hardware at_point(const Hardware& nominal, const std::vector<double>& point) {
  Hardware hardware = nominal;
  hardware.tube.mu = point[0];
  hardware.sheath.mu = point[1];
  const double reference = bearing_reference(nominal);
  const auto with_bearings = [&](double mu) {
    return reference > 0 ? point[2] * (mu / reference) : point[2];
  };
  hardware.bearing.mu = with_bearings(nominal.bearing.mu);
  if (hardware.block) hardware.block->mu = with_bearings(nominal.block->mu);
  if (nominal.sheath.angle_rad > 0) bend_sheaths(hardware, point[3] / nominal.sheath.angle_rad);
  hardware.sheath.angle_rad = point[3];
  return hardware;
}

Model at_point(const Model& nominal, const std::vector<double>& point) {
  return {at_point(nominal.hardware, point), nominal.effects, nominal.conditions};
}

Model draw_model(const Model& nominal, const UncertaintyRanges& ranges, std::uint64_t seed,
                 std::uint64_t draw) {
  const CoefficientBox box = coefficient_box(nominal.hardware, ranges);
  Model model = at_point(nominal, drawn_point(box, seed, draw));
  model.hardware.contact_draw = contact_draw(model.hardware, seed, draw);
  return model;
}

}  // namespace reeve::search
