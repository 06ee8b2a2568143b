#include "core/hand_closing.hpp"

namespace reeve::core {

HandClosing close_hand(const Hand& hand, const Network& network, const Mechanics& mechanics,
                       Kinematics& kinematics, Motion& motion) {
  return close_hand(hand, network, mechanics, kinematics, motion,
                    [](Grasp, double, const std::vector<double>&) {});
}

}  // namespace reeve::core
