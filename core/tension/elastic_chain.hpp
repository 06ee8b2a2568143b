// Tensions along an open chain of elastic segments with given slip directions.
//
// Segment i has length L_i (compliance, at EA = 1) and take-up E_i, Σ E_i >= 0; contact k between
// segments k and k+1 has decay e^{-phi_k}. In u = ln T the tensions minimise
//
//   Σ_i [ L_i e^{u_i} − E_i u_i ]
//   subject to  T_l = e^{-phi} T_r  where the tendon slides to the right,
//               T_r = e^{-phi} T_l  where it slides to the left,
//               e^{-phi} <= T_l / T_r <= e^{phi}  where it does not slide.
//
// Solved exactly by passing the derivative of the optimal cost from the first segment to the last.
// As a function of the tension t it is piecewise L t − E: a contact that slides scales t; one that
// does not opens a gap in which the derivative is zero (dynamic programming as for the taut string;
// N. A. Johnson, J. Comput. Graph. Stat. 22, 2013, for the idea). Without still contacts the chain
// is one product. No iteration, no tolerance; all tensions are 0 if nothing is taken up.
#pragma once

#include <span>
#include <vector>

#include "core/tension/kinematics.hpp"

namespace reeve::core {

struct ChainSegment {
  double length = 1;
  double take_up = 0;
};

struct ChainContact {
  double decay = 1;  // e^{-phi}, in (0, 1]
  Slide slide = Slide::no;
};

class ElasticChain {
 public:
  // contacts.size() + 1 == segments.size() == tension.size()
  void solve(std::span<const ChainSegment> segments, std::span<const ChainContact> contacts,
             std::span<double> tension);

 private:
  // The derivative is slope * t − offset for t up to `upto`. Slope and offset stand apart: side by
  // side they are loaded as one word, which has to wait for the slope that was just stored.
  struct Piece {
    double slope;
    double upto;
    double offset;
  };

  std::size_t start(std::span<const ChainSegment> segments, std::span<const ChainContact> contacts);
  void add(const ChainSegment& segment);
  void slide(double ratio);
  void hold(double decay, double rest);
  double root() const;

  std::vector<Piece> pieces_;
  std::vector<Piece> previous_;
  std::vector<double> rest_;
};

}  // namespace reeve::core
