// Finds the grasps in which the carriage is blocked, among all sets of held fingers but that of all
// fingers.
//
// A grasp jams if some tree of tendons gives nothing to the carriage (kinematics.hpp). If no two
// trees share a finger, each jams or moves by its own held fingers, and of n fingers
//
//   grasps that jam = 2^n − 1 − Π_t m_t,    m_t: sets of held fingers with which tree t moves
//
// A tree whose block motions its tendons settle closes its fingers by dl = 1 / Σ_f r_f over its
// closing fingers (tree_kinematics.hpp). If no r_f is negative, it jams where every finger with r_f
// > 0 is held. A tendon alone is such a tree. For any other tree each set is tried. A tendon that
// is still slack after the whole travel jams in none.
//
// Friction has no part in it, and no tension is solved.
#pragma once

#include <cstdint>
#include <vector>

#include "core/grasp.hpp"
#include "core/mechanics.hpp"
#include "core/network.hpp"
#include "core/tension/kinematics.hpp"

namespace reeve::core {

// More fingers than these of one tree that has to be tried, or of a network that is split or
// shared, are not tried: 2^16 sets take a second.
inline constexpr int most_fingers_tried = 16;

// Keeps its memory: but for trees that are tried, nothing is allocated in the steady state.
class JamFinder {
 public:
  // Returns the number of grasps that jam; infinite if it would take too many trials.
  double grasps(const Network& network, const Mechanics& mechanics);

  // Returns the sets of held fingers that jam while no smaller set within them does, small ones
  // first. A grasp that jams holds one of them. Returns nothing if grasps() is infinite.
  std::vector<Grasp> smallest(const Network& network, const Mechanics& mechanics);

 private:
  // The jams are those of one tree, or of a split or shared network as a whole.
  struct TreeJams {
    std::uint64_t fingers = 0;
    bool tried = false;  // each set of its fingers, or none of them can jam
    bool too_many = false;
    std::uint64_t needed = 0;                 // not tried: it jams where all of these are held
    double moving = 0;                        // sets of its fingers with which it moves
    std::vector<std::uint64_t> jamming = {};  // tried: the sets with which it jams
  };

  void find(const Network& network, const Mechanics& mechanics);
  void find_tree(const Network& network, const Mechanics& mechanics, std::size_t tree,
                 TreeJams& jams);
  template <typename Moves>
  void try_all(Moves moves, TreeJams& jams);
  TreeJams& next();

  std::vector<TreeJams> trees_;
  std::size_t count_ = 0;
  Kinematics kinematics_;
  Motion motion_;
  std::vector<double> ratios_;
  std::vector<double> closing_;
  std::vector<double> block_travel_;
};

}  // namespace reeve::core
