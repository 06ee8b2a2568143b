#include "search/evaluate/tendon_sums.hpp"

#include <algorithm>
#include <cmath>

namespace reeve::search {

PartCount parts_of(const Token& token) {
  switch (token.kind) {
    case TokenKind::motor_end:
      return {.sheaths = 1};
    case TokenKind::fixed_end:
      return {.fixed_ends = 1};
    case TokenKind::anchored_tip:
      return {.anchors = 1};
    case TokenKind::finger:
      if (token.tip == TipKind::tube) return {.tubes = 1};
      return {.pulleys = 1, .tip_bearings = 1};
    case TokenKind::tube_join:
      return {.tubes = 1};
    case TokenKind::bearing_join:
      return {.pulleys = 1, .fixed_pulleys = 1};
    case TokenKind::movable_pulley:
      return {.sheaths = 2, .pulleys = 1, .movable_pulleys = 1};
    case TokenKind::block_tail:
      return {.blocks = 1};
    case TokenKind::bar_pivot:
      return {.bars = 1};
    case TokenKind::block_pass:
    case TokenKind::becket:
    case TokenKind::bar_arms:
      return {};
  }
  return {};
}

TendonSums::TendonSums(const Hardware& hardware)
    : strand_mm_(hardware.strand_mm),
      motor_side_mm_(hardware.motor_side_mm),
      hand_mm_(hardware.hand_mm) {
  const auto law = [](const ContactLaw& given) {
    const double phi = given.exponent();
    return Law{phi, std::exp(-phi), std::exp(phi)};
  };
  tube_ = law(hardware.tube);
  bearing_ = law(hardware.bearing);
  sheath_ = law(hardware.sheath);
}

// Expands a token as core/network does.
void TendonSums::read_token(const Tendon& tendon, std::size_t i) {
  const Token& token = tendon.walk[i];
  switch (token.kind) {
    case TokenKind::motor_end:
      if (i > 0) add_link(sheath_);
      add_motor_side();
      if (i == 0) add_link(sheath_);
      return;
    case TokenKind::finger:
      return add_link(token.tip == TipKind::tube ? tube_ : bearing_);
    case TokenKind::tube_join:
      return add_link(tube_);
    case TokenKind::bearing_join:
      return add_link(bearing_);
    case TokenKind::movable_pulley:
      add_link(sheath_);
      add_motor_side();
      add_link(bearing_);
      add_motor_side();
      return add_link(sheath_);
    default:  // an end that nothing touches; blocks are not read
      return;
  }
}

// Fingers count from 1 in the order of the walk, of which `fingers` have been passed.
void TendonSums::read_gap(const Tendon& tendon, std::size_t i, int fingers) {
  const std::size_t next = i + 1 == tendon.walk.size() ? 0 : i + 1;
  if (is_of_finger(tendon.walk[i].kind)) {
    pieces_.push_back({strand_mm_, false, fingers});
  } else if (is_of_finger(tendon.walk[next].kind)) {
    pieces_.push_back({strand_mm_, false, next == 0 ? 1 : fingers + 1});
  } else {
    pieces_.push_back({hand_mm_, false, 0});
  }
}

// False where a block ties it, or no motor pulls it.
bool TendonSums::read(const Tendon& tendon, TreeOutline& outline) {
  pieces_.clear();
  links_.clear();
  closed_ = tendon.closed;
  outline.parts = {.knots = closed_ ? 1 : 0};
  const std::size_t n = tendon.walk.size();
  int& fingers = outline.fingers = 0;
  for (std::size_t i = 0; i < n; ++i) {
    if (is_of_block(tendon.walk[i].kind)) return false;
    if (is_of_finger(tendon.walk[i].kind)) ++fingers;
    outline.parts += parts_of(tendon.walk[i]);
    if (i > 0 || !closed_) read_token(tendon, i);
    if (i + 1 < n || closed_) read_gap(tendon, i, fingers);
  }
  if (closed_) read_token(tendon, 0);
  motor_sides_ = 0;
  strands_ = 0;
  strands_of_.fill(0);
  for (const Piece& piece : pieces_) {
    if (piece.motor_side) ++motor_sides_;
    if (piece.finger == 0) continue;
    ++strands_;
    ++strands_of_[static_cast<std::size_t>(piece.finger)];
  }
  return motor_sides_ > 0;
}

// Returns how many contacts are still.
std::size_t TendonSums::set_slips(int held, int closing) {
  int slip = 0;
  std::size_t still = 0;
  for (std::size_t k = 0; k < links_.size(); ++k) {
    const Piece& piece = pieces_[k];
    if (piece.motor_side) slip -= closing;
    if (piece.finger > 0 && piece.finger != held) slip += motor_sides_;
    links_[k].slip = slip;
    if (slip == 0) ++still;
  }
  return closed_ ? circulate() : still;
}

std::size_t TendonSums::circulate() {
  slips_.clear();
  double total = 0;
  for (const Link& link : links_) {
    slips_.push_back({link.slip, link.law->phi});
    total += link.law->phi;
  }
  std::sort(slips_.begin(), slips_.end(),
            [](const WeightedSlip& a, const WeightedSlip& b) { return a.slip > b.slip; });
  double above = 0;
  const auto median = std::find_if(slips_.begin(), slips_.end() - 1, [&](const WeightedSlip& slip) {
    above += slip.weight;
    return above >= total / 2;
  });
  std::size_t still = 0;
  for (Link& link : links_) {
    link.slip -= median->slip;
    if (link.slip == 0) ++still;
  }
  return still;
}

// Between contacts that are still, tensions are a product, and its pieces yield as one: the chain
// has those alone. From this piece on.
void TendonSums::make_chain(std::size_t first, int held, double closing) {
  const std::size_t n = pieces_.size();
  segments_.clear();
  contacts_.clear();
  ChainSegment group{0, 0};
  double tension = 1;
  for (std::size_t j = 0, k = first; j < n; ++j) {
    const Piece& piece = pieces_[k];
    tension_[k] = tension;
    group.length += piece.length * tension;
    if (piece.finger > 0 && piece.finger != held) group.take_up += closing;
    if (j + 1 == n) break;
    const Link& link = links_[k];
    if (link.slip == 0) {
      segments_.push_back(group);
      // This contact joins the first piece of the group to its last one, which is in it already.
      contacts_.push_back(tension > 1 ? ChainContact{1 / tension, Slide::to_right}
                                      : ChainContact{tension, Slide::to_left});
      segments_.push_back({0, 0});
      contacts_.push_back({link.law->decay, Slide::no});
      group = {0, 0};
      tension = 1;
    } else {
      tension *= link.slip > 0 ? link.law->growth : link.law->decay;
    }
    k = k + 1 < n ? k + 1 : 0;
  }
  segments_.push_back(group);
}

void TendonSums::solve_from(std::size_t first, int held, double closing) {
  make_chain(first, held, closing);
  chain_tension_.resize(segments_.size());
  chain_.solve(segments_, contacts_, chain_tension_);
  const double* scale = chain_tension_.data();
  const std::size_t n = pieces_.size();
  for (std::size_t j = 0, k = first; j < n; ++j) {
    tension_[k] *= *scale;
    if (j + 1 < n && links_[k].slip == 0) scale += 2;
    k = k + 1 < n ? k + 1 : 0;
  }
}

// Opens the loop as TensionSolver does: at a still contact in whose cone the tensions then lie.
void TendonSums::solve_loop(std::size_t still, int held, double closing) {
  const std::size_t n = pieces_.size();
  for (std::size_t k = 0; k < n; ++k) {
    if (links_[k].slip != 0) continue;
    const std::size_t next = k + 1 < n ? k + 1 : 0;
    solve_from(next, held, closing);
    const auto [less, more] = std::minmax(tension_[k], tension_[next]);
    constexpr double tolerance = 1e-12;
    if (still == 1 || more * links_[k].law->decay <= less * (1 + tolerance)) return;
  }
}

void TendonSums::tally(int held, double closing, TreeSums& sums) const {
  StrandTally strands;
  double motor = 0;
  double least = tension_[0];
  double most = tension_[0];
  for (std::size_t k = 0; k < pieces_.size(); ++k) {
    const double tension = tension_[k];
    least = std::min(least, tension);
    most = std::max(most, tension);
    if (pieces_[k].motor_side) {
      motor += tension;
    } else if (pieces_[k].finger > 0) {
      strands.add(tension, pieces_[k].finger == held ? 0 : closing);
    }
  }
  sums = {false, std::isnormal(least) && std::isnormal(most), motor, strands};
}

bool TendonSums::find_sums(int held, TreeSums& sums) {
  const int closing_strands =
      strands_ - (held > 0 ? strands_of_[static_cast<std::size_t>(held)] : 0);
  if (closing_strands == 0) return false;
  const double closing = static_cast<double>(motor_sides_) / closing_strands;
  const std::size_t still = set_slips(held, closing_strands);
  tension_.resize(pieces_.size());
  if (closed_) {
    solve_loop(still, held, closing);
  } else {
    solve_from(0, held, closing);
  }
  tally(held, closing, sums);
  return true;
}

bool TendonSums::find(const Tendon& tendon, int held, TreeOutline& outline) {
  if (!read(tendon, outline)) return false;
  outline.sums.resize(static_cast<std::size_t>(held) + 1);
  for (int state = 0; state <= held; ++state) {
    if (!find_sums(state, outline.sums[static_cast<std::size_t>(state)])) return false;
  }
  return true;
}

}  // namespace reeve::search
