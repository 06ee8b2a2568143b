#include "core/tension/split_kinematics.hpp"

#include <algorithm>
#include <cmath>

#include "core/tension/tied_split_kinematics.hpp"

namespace reeve::core {
namespace {

// Per unit of carriage travel: fingers that give up more than this beyond it leave a piece slack.
// Sweeps end where rounding does, and in any case.
constexpr double tight = 1e-9;
constexpr double converged = 1e-15;
constexpr int most_sweeps = 10000;

struct Piece {
  double motor_sides = 0;
  std::vector<double> strands;  // count for each finger that closes
  double norm = 0;              // A W Aᵀ
  double lambda = 0;
};

Piece piece(const Network& network, const TendonSpan& tendon, const Mechanics& mechanics,
            Grasp grasp) {
  Piece result;
  result.strands.assign(static_cast<std::size_t>(network.fingers), 0.0);
  for (std::size_t i = tendon.first_segment; i < tendon.first_segment + tendon.segments; ++i) {
    const Segment& segment = network.segments[i];
    if (segment.kind == SegmentKind::motor_side) result.motor_sides += 1;
    if (segment.kind == SegmentKind::strand && !grasp.holds(segment.finger)) {
      result.strands[static_cast<std::size_t>(segment.finger - 1)] += 1;
    }
  }
  for (std::size_t f = 0; f < result.strands.size(); ++f) {
    result.norm += result.strands[f] * result.strands[f] * mechanics.closing[f];
  }
  return result;
}

double given_up(const Piece& piece, const std::vector<double>& closing) {
  double sum = 0;
  for (std::size_t f = 0; f < closing.size(); ++f) sum += piece.strands[f] * closing[f];
  return sum;
}

bool is_pulled(const Piece& piece) { return piece.motor_sides > 0 && piece.norm > 0; }

// The greatest change of a closing.
double sweep(std::vector<Piece>& pieces, const Mechanics& mechanics, std::vector<double>& closing) {
  double change = 0;
  for (Piece& piece : pieces) {
    if (!is_pulled(piece)) continue;
    const double lacking = piece.motor_sides - given_up(piece, closing);
    const double step = std::max(-piece.lambda, lacking / piece.norm);
    piece.lambda += step;
    for (std::size_t f = 0; f < closing.size(); ++f) {
      const double by = step * mechanics.closing[f] * piece.strands[f];
      closing[f] += by;
      change = std::max(change, std::abs(by));
    }
  }
  return change;
}

}  // namespace

SplitClosing split_closing(const Network& network, const Mechanics& mechanics, Grasp grasp) {
  if (!network.blocks.empty()) return tied_split_closing(network, mechanics, grasp);
  std::vector<Piece> pieces;
  pieces.reserve(network.tendons.size());
  for (const TendonSpan& tendon : network.tendons) {
    pieces.push_back(piece(network, tendon, mechanics, grasp));
  }
  SplitClosing result;
  result.closing.assign(static_cast<std::size_t>(network.fingers), 0.0);
  for (int i = 0; i < most_sweeps; ++i) {
    if (sweep(pieces, mechanics, result.closing) < converged) break;
  }
  for (const Piece& piece : pieces) {
    result.jams.push_back(piece.motor_sides > 0 && piece.norm == 0 ? 1 : 0);
    const bool slack =
        piece.motor_sides == 0 ||
        (is_pulled(piece) && given_up(piece, result.closing) > piece.motor_sides + tight);
    result.slack.push_back(slack ? 1 : 0);
  }
  return result;
}

}  // namespace reeve::core
