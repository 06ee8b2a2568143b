// Tensions of tendons that blocks tie together, with given slip directions.
//
// Segment i has length L_i (compliance, at EA = 1) and take-up E_i, below 0 only where a carriage
// lets out in a jam. With s_k the slip of the
// contacts that do not slide at order one, and z_b the blocks' order-epsilon travel,
//
//   L_i T_i = E_i + s_right − s_left + z of a pass, an arm or a becket − z of a tail
//   T_l = e^{-phi} T_r or T_r = e^{-phi} T_l     where the tendon slides; given ratios at bars
//   e^{-phi} <= T_l / T_r <= e^{phi}             where it does not, with s > 0 only at the bound
//                                                T_l = e^{-phi} T_r, and s < 0 only at the other
//   Σ passes (T_l + T_r) + Σ beckets T = Σ tails T      at each block and bar
//
//   a tendon that the others leave room is slack: T = 0 along it, and Σ (E + z …) <= 0
//
// A block's balance is linear in T, not in ln T, so that this is no minimum of a potential; it
// stays monotone. Between contacts that stick, tensions are one unknown; eliminated, there is one
// linear equation for each block. Which contacts stick and which creep is found by exchanging those
// whose condition is violated, all at once and, if that does not end, one by one by lot (block
// pivoting for complementarity problems: J. J. Júdice, F. M. Pires, Computers & Operations Research
// 21, 1994). Where every contact slides there is nothing to find, and a loop is opened at a contact
// that does not slide (tension.hpp).
#pragma once

#include <Eigen/Core>

#include <cstdint>
#include <vector>

#include "core/mechanics.hpp"
#include "core/network.hpp"
#include "core/tension/kinematics.hpp"

namespace reeve::core {

class TreeTension {
 public:
  // Writes the tensions of the tree's segments. False if the exchanges do not end or tensions leave
  // the range of a double; they are then of no use.
  bool solve(const Network& network, const Mechanics& mechanics, const Motion& motion,
             std::size_t tree, std::vector<double>& tension);

 private:
  // One number for each block of a tree; no memory from the heap.
  using Vector = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, block_keys, 1>;

  enum class Link : std::uint8_t {
    ratio,  // T_next = ratio * T, whatever the slip
    stick,  // no slip: the tensions lie in the cone
    creep_to_right,
    creep_to_left,
    none,  // the end of a chain
  };

  struct Pull {
    std::size_t block;
    double sign;
  };

  // A segment, and the contact behind it.
  struct Cell {
    std::size_t segment = 0;
    double length = 1;
    double take_up = 0;
    Link link = Link::none;
    double decay = 1;  // e^{-phi} of the contact
    double ratio = 1;  // used by Link::ratio
    double arms = 1;   // left over right, at a bar of an open tendon
    bool is_bar = false;
    std::size_t pulls = 0;  // end of its part of pulls_
    double relative = 1;    // tension over that of the first cell since a stick
    double tension = 0;
  };

  // openings_ holds the contacts at which a loop may be opened.
  struct Loop {
    std::size_t tendon;
    std::size_t first_opening;
    std::size_t end_opening;
    std::size_t chosen;
  };

  // The cells of one tendon.
  struct Chain {
    std::size_t first_cell;
    std::size_t end_cell;
    std::size_t first_pull;
    bool slack = false;
  };

  // Cells whose tensions have given ratios, up to a stick: Λ t = E + c·z, and β t in the balances.
  struct Run {
    std::size_t end_cell;
    double stiff = 0;    // Λ
    double take_up = 0;  // E
  };

  // Another link behind a cell, or another state of a chain.
  struct Exchange {
    std::size_t at;
    Link link;
    bool of_chain;
  };

  void find_loops(const Network& network, const Mechanics& mechanics, const Motion& motion,
                  std::size_t tree);
  bool next_openings();
  void build(const Network& network, const Mechanics& mechanics, const Motion& motion,
             std::size_t tree);
  void add_chain(const Network& network, const Mechanics& mechanics, const Motion& motion,
                 const TendonSpan& tendon, std::size_t first);
  void add_pulls(const Network& network, const TendonSpan& tendon, std::size_t i);
  bool settle();
  Run sum_up(std::size_t first_cell, std::size_t& pull, Vector& force, Vector& gain);
  template <typename Visit>
  void for_each_run(Visit visit);
  void solve_linear();
  double room(const Chain& chain) const;
  void find_wrong_links(const Chain& chain);
  void find_exchanges();
  void apply(const Exchange& exchange);
  bool write(std::vector<double>& tension) const;
  bool loops_fit(const Network& network, const Mechanics& mechanics,
                 const std::vector<double>& tension) const;

  std::vector<Cell> cells_;
  std::vector<Pull> pulls_;
  std::vector<Chain> chains_;
  std::vector<Exchange> exchanges_;
  std::vector<Loop> loops_;
  std::vector<std::size_t> openings_;
  std::vector<double> travel_;  // travels of the tree's blocks, by their number in the network
  double scale_ = 0;            // greatest of the take-ups and travels
  std::vector<std::size_t> in_tree_;  // the tree's blocks
};

}  // namespace reeve::core
