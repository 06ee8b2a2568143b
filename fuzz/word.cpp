#include <algorithm>
#include <cmath>
#include <numeric>

#include "core/canonical.hpp"
#include "core/mechanics.hpp"
#include "core/network.hpp"
#include "core/notation.hpp"
#include "core/tension/tension.hpp"
#include "fuzz/fuzzed.hpp"

namespace reeve::fuzz {
namespace {

using namespace core;

// Longer ones are read, but not solved: there the time goes into few of them.
constexpr std::size_t longest_solved = 120;
constexpr double rounding = 1e-6;

void check_cones(const Network& network, const Mechanics& mechanics, const TensionState& state) {
  for (const TendonSpan& tendon : network.tendons) {
    for (std::size_t k = 0; k < tendon.contacts; ++k) {
      const std::size_t contact = tendon.first_contact + k;
      if (network.contacts[contact].kind == ContactKind::bar) continue;
      const ContactEnds ends = ends_of(tendon, k);
      const double greater = std::max(state.tension[ends.left], state.tension[ends.right]);
      const double less = std::min(state.tension[ends.left], state.tension[ends.right]);
      require(less >= 0, "no tension is below 0");
      require(greater * mechanics.decay[contact] <= less * (1 + rounding) + rounding,
              "a contact keeps the capstan inequality");
    }
  }
}

void check_tensions(const Network& network, const Mechanics& mechanics, Grasp grasp,
                    Direction direction) {
  const TensionState state = tensions(network, mechanics, grasp, direction);
  double motor = 0;
  for (std::size_t k = 0; k < network.segments.size(); ++k) {
    if (network.segments[k].kind == SegmentKind::motor_side) motor += state.tension[k];
  }
  require(std::abs(motor - 1) < rounding, "motor-side tensions add up to the motor's");
  check_cones(network, mechanics, state);
}

void check_forms(const Routing& routing) {
  const std::string written = to_word(routing);
  require(parse_routing(written) == routing, "what is printed is read as it was");
  for (const FingerIdentity identity : {FingerIdentity::identical, FingerIdentity::distinct}) {
    const Routing form = canonical(routing, identity);
    require(canonical(form, identity) == form, "a canonical form is its own");
    require(parse_routing(to_word(form)) == form, "a canonical form is read as it was");
  }
}

}  // namespace

void word(std::string_view bytes) {
  or_refused([&] {
    const Routing routing = parse_routing(bytes);
    check_forms(routing);
    if (bytes.size() > longest_solved || !is_actuated(routing)) return;
    const Network network = expand(routing);
    const Mechanics numbers = mechanics(network, {});
    for (const WeightedGrasp& grasp : single_grasps(network.fingers)) {
      for (const Direction direction : {Direction::pull, Direction::release}) {
        or_refused([&] { check_tensions(network, numbers, grasp.grasp, direction); });
      }
    }
  });
}

}  // namespace reeve::fuzz
