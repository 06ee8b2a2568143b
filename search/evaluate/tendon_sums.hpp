// The sums of a tendon that no block ties, read off its tokens.
//
// What TensionSolver finds by way of a network, with all its arrays, is for one tendon with like
// fingers a matter of counting. Of m motor-side segments and c strands of fingers that close, each
// strand gives up dl = m/c of the carriage's way; behind the first k segments, a of them motor
// sides and b closing strands, the tendon slips by
//
//   s_k = (b m − a c) / c
//
// so that its direction is the sign of a whole number, and on a loop, where what goes round is the
// friction-weighted median, one of those numbers. Between contacts that are still, tensions are one
// product of e^{±phi}; how these products stand to each other, ElasticChain says.
//
// Equal to what TensionSolver gives but for rounding: for estimates, which have a margin.
// Assumptions: as of tension.hpp; all fingers are alike and no contact has a law of its own.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/hardware.hpp"
#include "core/mechanics.hpp"
#include "core/tension/elastic_chain.hpp"
#include "search/evaluate/tree_spans.hpp"

namespace reeve::search {

// Parts that a token stands for, as core/performance counts them in a network. A block or bar is
// where its tail or pivot is: in what is generated each has one.
PartCount parts_of(const Token& token);

class TendonSums {
 public:
  explicit TendonSums(const Hardware& hardware);

  // The states in which no finger is held, and each of the first `held` in the order of the walk,
  // whatever their numbers. False where it is no such tendon, or jams in one of these. Keeps the
  // memory of `outline`.
  bool find(const Tendon& tendon, int held, TreeOutline& outline);

 private:
  struct Law {
    double phi = 0;
    double decay = 1;  // e^{-phi}
    double growth = 1;
  };
  // A contact, between the piece of the same place and the next.
  struct Link {
    const Law* law;
    int slip = 0;  // slip in units of 1/c
  };
  // A segment.
  struct Piece {
    double length = 0;
    bool motor_side = false;
    int finger = 0;  // finger of a strand, from 1; otherwise 0
  };

  bool read(const Tendon& tendon, TreeOutline& outline);
  void read_token(const Tendon& tendon, std::size_t i);
  void read_gap(const Tendon& tendon, std::size_t i, int fingers);
  void add_motor_side() { pieces_.push_back({motor_side_mm_, true, 0}); }
  void add_link(const Law& law) { links_.push_back({&law, 0}); }
  bool find_sums(int held, TreeSums& sums);
  std::size_t set_slips(int held, int closing);
  std::size_t circulate();
  void make_chain(std::size_t first, int held, double closing);
  void solve_from(std::size_t first, int held, double closing);
  void solve_loop(std::size_t still, int held, double closing);
  void tally(int held, double closing, TreeSums& sums) const;

  double strand_mm_ = 0;
  double motor_side_mm_ = 0;
  double hand_mm_ = 0;
  Law tube_;
  Law bearing_;
  Law sheath_;

  // State of one tendon.
  bool closed_ = false;
  int motor_sides_ = 0;
  int strands_ = 0;
  std::array<int, max_fingers + 1> strands_of_{};  // [finger], from 1
  std::vector<Piece> pieces_;
  std::vector<Link> links_;  // the last link of a loop leads back to the first piece

  // Working memory for one state.
  struct WeightedSlip {
    int slip;
    double weight;
  };
  std::vector<WeightedSlip> slips_;
  std::vector<double> tension_;  // tension of each piece
  ElasticChain chain_;
  std::vector<ChainSegment> segments_;
  std::vector<ChainContact> contacts_;
  std::vector<double> chain_tension_;
};

}  // namespace reeve::search
