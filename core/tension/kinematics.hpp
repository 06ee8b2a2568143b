// Computes the motion that carriage and fingers impose on a tendon, and its slip at the contacts.
//
// The carriage travels D = 1, those of several motors v_c D as the grasp says, and an end on a
// spool of its own r_i times that. Pulling, every motor-side segment i has e_i = +r_i v_c D imposed
// and each strand of a closing finger e_i = -dl; releasing, the signs are reversed. The closing
// fingers of a tendon share its travel by their closing weights, so that along a tendon of an
// inextensible thread the e_i add up to zero. Slip s_k (from the left to the right segment of
// contact k) follows:
//
//   e_i + s_i - s_{i-1} = 0,      on a loop up to a circulation c that minimises Σ phi_k |s_k|:
//                                 the friction-weighted median
//
// A tip with guides has its own phi_k there, and the guides of both strands, which slide by dl − s
// and dl + s at the palm, add S |dl − s| + S |dl + s| (finger_guides.hpp). Where the median is
// there, s = ± dl, a strand rests at the palm, and its tip counts as one that does not slide.
//
// The thread is only nearly inextensible: what yields (e_i < 0: fingers when pulling, the carriage
// when releasing, a carriage that lets out while another pulls) yields a fraction epsilon less than
// what drives, and that is the take-up which stretches the tendon. take_up holds it per segment, in
// units of epsilon. Where carriages pull and no finger of a tendon can move, it jams: nothing slips
// at order one, and the whole travel is take-up; in release, where a jammed carriage can only give
// way, what stays stretched is the hand side. A tendon whose carriages all stand still carries
// nothing; one that is let out in all would open its fingers, which is a fault.
//
// A tendon with slack s, whose motor sides take in m D, carries nothing up to D = s / m. From there
// on it moves like the others, and its take-up is the share 1 − s / (m D) of what it would be.
//
// Tendons that blocks tie together close as tree_kinematics.hpp says; a block that moves by z adds
// z to what is imposed on the segments that it pulls, and takes z from its tails.
//
// Fingers that trees share, and extensors, close as shared_kinematics.hpp says.
//
// docs/model.md, sections 2 and 3, derives this.
#pragma once

#include <cstdint>
#include <vector>

#include "core/grasp.hpp"
#include "core/mechanics.hpp"
#include "core/network.hpp"
#include "core/tension/tension_fault.hpp"

namespace reeve::core {

enum class Slide : std::int8_t { to_left = -1, no = 0, to_right = 1 };

// Arrays parallel to the network's tendons, segments, contacts and fingers.
struct Motion {
  std::vector<char> jams;
  std::vector<char> slack;                  // one per tendon; empty if none is
  TensionFault fault = TensionFault::none;  // that of one tendon or tree, or of all of them
  int opposed = 0;  // finger that other tendons do not let close or open; 0 if none jams so
  std::vector<double> imposed;
  std::vector<double> take_up;
  std::vector<double> slip;          // at D = 1; exactly 0 where the contact does not slide
  std::vector<double> closing;       // dl of fingers 1 … n at D = 1, as it would be in a pull
  std::vector<double> block_travel;  // z of the blocks at D = 1, as it would be in a pull

  bool is_slack(std::size_t tendon) const { return !slack.empty() && slack[tendon] != 0; }
};

inline Slide slide_of(double slip) {
  if (slip == 0) return Slide::no;
  return slip > 0 ? Slide::to_right : Slide::to_left;
}

// How a tip's slip stands to the guides of its finger.
enum class GuideUse : std::uint8_t {
  whole,             // the strands pass them one after the other; or there are none
  one_strand_rests,  // likewise, but at the palm end of one strand nothing slides
  alike,             // both strands slide the same way past them
};

GuideUse guide_use(const Network& network, const Mechanics& mechanics, std::size_t contact,
                   const std::vector<double>& slip, const std::vector<double>& closing);

// How the contact counts: one of a loop at which guides hold does not slide.
Slide slide_at(const Network& network, const Mechanics& mechanics, const Motion& motion,
               const TendonSpan& tendon, std::size_t contact);

// Returns the share of the tendon's travel behind its slack: 0 if it never gets taut, 1 without
// slack.
double taut_share(const Network& network, const TendonSpan& tendon, const Mechanics& mechanics,
                  const Grasp& grasp);

class Kinematics {
 public:
  // Keeps the memory of `motion`.
  void solve(const Network& network, const Mechanics& mechanics, Grasp grasp, Direction direction,
             Motion& motion);

 private:
  struct WeightedPoint {
    double at;
    double weight;
  };

  void solve_tree(const Network& network, const Mechanics& mechanics, Grasp grasp,
                  Direction direction, std::size_t tree, Motion& motion);
  void settle_slip(const Network& network, const TendonSpan& tendon, const Mechanics& mechanics,
                   Direction direction, Motion& motion);
  void solve_split(const Network& network, const Mechanics& mechanics, Grasp grasp,
                   Direction direction, Motion& motion);
  void solve_tendon(const Network& network, const Mechanics& mechanics, const Grasp& grasp,
                    Direction direction, std::size_t tendon, Motion& motion);
  double circulation(const Network& network, const TendonSpan& tendon, const Mechanics& mechanics,
                     const Motion& motion);

  std::vector<WeightedPoint> points_;
};

}  // namespace reeve::core
