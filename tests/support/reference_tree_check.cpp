#include "tests/support/reference_tree_check.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "tests/support/reference_groups.hpp"

namespace reeve::testing::reference {

namespace {

constexpr Real ratio_tolerance = 1e-11L;
constexpr Real length_tolerance = 1e-12L;
constexpr Real slip_tolerance = 1e-14L;

class TreeCheck {
 public:
  TreeCheck(const Tree& tree, const TreeState& state)
      : tree_(tree), state_(state), known_(tree.contacts.size(), false) {}

  TreeFaults run() {
    if (!(state_.tension.minCoeff() > 0)) {
      faults_.other = "a tension is not above 0";
      return faults_;
    }
    check_balances();
    for (const auto& [contact, difference] : known_by_kinematics(tree_)) {
      known_[contact] = true;
      if (!(std::abs(lean(contact) - difference) < ratio_tolerance))
        faults_.other = "a ratio is not the known one";
    }
    for (std::size_t k = 0; k < known_.size(); ++k)
      if (!known_[k]) check_cone(k);
    for (const Span& span : tree_.spans) check_slips(span);
    return faults_;
  }

 private:
  Real lean(std::size_t k) const {
    const TreeContact& contact = tree_.contacts[k];
    return std::log(state_.tension(contact.left) / state_.tension(contact.right));
  }

  void check_balances() {
    const Vector off = tree_.hangs.transpose() * state_.tension;
    const Vector size = tree_.hangs.cwiseAbs().transpose() * state_.tension;
    if (!(off.array().abs() <= length_tolerance * size.array()).all())
      faults_.other = "a block is out of balance";
  }

  void check_cone(std::size_t k) {
    const Real d = lean(k), phi = tree_.contacts[k].phi;
    const int side = state_.side[k];
    const Real excess = std::abs(d) - phi;
    if (side != 0 && std::abs(d - static_cast<Real>(side) * phi) < ratio_tolerance) return;
    if (side != 0 && excess < 0) faults_.contacts.push_back({k, 0, 0});
    if (excess > slip_tolerance) faults_.contacts.push_back({k, d > 0 ? 1 : -1, excess / phi});
  }

  bool passes_length(Index k) const {
    const auto at = static_cast<std::size_t>(k);
    return known_[at] || state_.side[at] != 0;
  }

  // Length passes along a tendon only in the stretches between contacts without slip.
  void check_slips(const Span& span) {
    Index cut = span.loop ? cut_of(span) : span.segments - 1;
    std::vector<Index> stretch;
    for (Index count = 0; count < span.segments; ++count) {
      const Index i = (cut + 1 + count) % span.segments;
      stretch.push_back(i);
      const bool last = count + 1 == span.segments;
      if (!last && passes_length(span.contact + i)) continue;
      const bool round = last && span.loop && passes_length(span.contact + cut);
      check_stretch(span, stretch, round);
      stretch.clear();
    }
  }

  // A contact that no length passes, if the loop has one; otherwise the one where least pulls.
  Index cut_of(const Span& span) const {
    Index cut = 0;
    for (Index k = 0; k < span.contacts; ++k) {
      if (!passes_length(span.contact + k)) return k;
      if (state_.tension(span.segment + k) < state_.tension(span.segment + cut)) cut = k;
    }
    return cut;
  }

  struct Slip {
    std::size_t contact;
    Real value, size;
  };

  // Each slip is summed from the end of the stretch that is smaller. Round a loop, one more slip
  // is free, and takes a place among them as 0.
  void check_stretch(const Span& span, const std::vector<Index>& stretch, bool round) {
    Real total = 0, total_size = 0;
    for (const Index i : stretch) {
      total += missing(span.segment + i);
      total_size += size(span.segment + i);
    }
    if (!(std::abs(total) <= length_tolerance * total_size)) faults_.other = "a length is off";
    std::vector<Slip> slips;
    Real head = 0, head_size = 0;
    for (std::size_t j = 0; j < stretch.size(); ++j) {
      const bool last = j + 1 == stretch.size();
      if (last && !round) break;
      head += missing(span.segment + stretch[j]);
      head_size += size(span.segment + stretch[j]);
      Real tail = 0, tail_size = 0;
      for (std::size_t rest = j + 1; rest < stretch.size(); ++rest) {
        tail += missing(span.segment + stretch[rest]);
        tail_size += size(span.segment + stretch[rest]);
      }
      const bool from_head = !last && head_size < tail_size;
      slips.push_back({static_cast<std::size_t>(span.contact + stretch[j]),
                       last        ? 0
                       : from_head ? head
                                   : -tail,
                       std::min(head_size, tail_size)});
    }
    check_directions(slips, round ? circulation(slips) : 0);
  }

  // What the segment takes more than is imposed on it, and the size of the terms.
  Real missing(Index i) const {
    return tree_.c(i) * (tree_.length(i) * state_.tension(i) - tree_.elastic(i) -
                         tree_.hangs.row(i).dot(state_.z));
  }
  Real size(Index i) const {
    return tree_.c(i) * (tree_.length(i) * state_.tension(i) + std::abs(tree_.elastic(i)) +
                         tree_.hangs.row(i).cwiseAbs().dot(state_.z.cwiseAbs()));
  }

  // The free slip of a loop that suits the directions best.
  Real circulation(const std::vector<Slip>& slips) const {
    constexpr Real far = std::numeric_limits<Real>::infinity();
    Real least = -far, most = far;
    for (const auto& [contact, value, size] : slips) {
      if (state_.side[contact] > 0) most = std::min(most, -value);
      if (state_.side[contact] < 0) least = std::max(least, -value);
    }
    return least == -far ? std::min(most, Real(0))
           : most == far ? std::max(least, Real(0))
                         : (least + most) / 2;
  }

  // To the right where T_left is the smaller, to the left where it is the greater.
  void check_directions(const std::vector<Slip>& slips, Real circulation) {
    for (const auto& [contact, value, size] : slips) {
      const Real wrong = static_cast<Real>(state_.side[contact]) * (value + circulation);
      const Real noise = slip_tolerance * (size + std::abs(circulation));
      if (wrong > noise) faults_.contacts.push_back({contact, 0, wrong / (size + noise)});
    }
  }

  const Tree& tree_;
  const TreeState& state_;
  std::vector<bool> known_;
  TreeFaults faults_;
};

// factor . z <= most, a sum of terms of that size.
struct Inequality {
  Vector factor;
  Real most, size;
};

Vector block_column(const Tree& tree, const Span& span, Index block) {
  return tree.hangs.col(block).segment(span.segment, span.segments);
}

Inequality room_of(const Tree& tree, const Span& span, const std::vector<bool>& held,
                   const Vector& z) {
  const Vector c = tree.c.segment(span.segment, span.segments);
  const Real elastic = c.dot(tree.elastic.segment(span.segment, span.segments));
  Inequality room{Vector::Zero(z.size()), -elastic, std::abs(elastic)};
  for (Index b = 0; b < z.size(); ++b) {
    const Real factor = c.dot(block_column(tree, span, b));
    if (!held[static_cast<std::size_t>(b)]) {
      room.factor(b) = factor;
    } else {
      room.most -= factor * z(b);
      room.size += std::abs(factor * z(b));
    }
  }
  return room;
}

// Fourier-Motzkin: what the inequalities say without that unknown.
std::vector<Inequality> without_unknown(const std::vector<Inequality>& all, Index unknown) {
  std::vector<Inequality> rest;
  for (const Inequality& one : all) {
    const Real up = one.factor(unknown);
    if (up == 0) rest.push_back(one);
    for (const Inequality& other : all) {
      const Real down = -other.factor(unknown);
      if (!(up > 0 && down > 0)) continue;
      rest.push_back({one.factor / up + other.factor / down, one.most / up + other.most / down,
                      one.size / up + other.size / down});
    }
  }
  return rest;
}

}  // namespace

TreeFaults check(const Tree& tree, const TreeState& state) { return TreeCheck(tree, state).run(); }

bool slack_fits(const Tree& tree, const std::vector<bool>& slack, const Vector& z) {
  const Index blocks = tree.hangs.cols();
  std::vector<bool> held(static_cast<std::size_t>(blocks), false);
  for (std::size_t t = 0; t < slack.size(); ++t)
    for (Index b = 0; b < blocks; ++b)
      if (!slack[t] && !block_column(tree, tree.spans[t], b).isZero(0))
        held[static_cast<std::size_t>(b)] = true;
  std::vector<Inequality> all;
  for (std::size_t t = 0; t < slack.size(); ++t)
    if (slack[t]) all.push_back(room_of(tree, tree.spans[t], held, z));
  for (Index b = 0; b < blocks; ++b) all = without_unknown(all, b);
  return std::all_of(all.begin(), all.end(),
                     [](const Inequality& i) { return i.most >= -length_tolerance * i.size; });
}

}  // namespace reeve::testing::reference
