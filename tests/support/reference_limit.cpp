#include "tests/support/reference_limit.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <utility>
#include <vector>

namespace reeve::testing::reference {

namespace {

class Limit {
 public:
  Limit(const Problem& problem, Sides sides)
      : problem_(problem), sides_(std::move(sides)), u_(Vector::Zero(problem.length.size())) {}

  // u, once the optimality conditions hold; repairs sides that do not meet them.
  Vector solve() {
    for (int attempt = 0; attempt < 1000; ++attempt) {
      evaluate();
      // One at a time in the end, lest two repairs undo each other.
      if (!(attempt < 10 ? repair_all() : repair_one())) return u_;
    }
    throw std::logic_error("reference model: optimality conditions not met");
  }

 private:
  static constexpr Real tolerance = 1e-14L;

  Index next(Index i) const { return (i + 1) % problem_.length.size(); }

  int& side(Index k) { return sides_[static_cast<std::size_t>(k)]; }

  bool joined(Index k) { return k != cut_ && (tied(problem_, k) || side(k) != 0); }

  void evaluate() {
    evaluate_once();
    if (cut_ >= 0 && side(cut_) != 0) evaluate_once();  // now that the least tension is known
  }

  void evaluate_once() {
    const Index n = problem_.length.size();
    choose_cut();
    force_ = noise_ = Vector::Zero(problem_.phi.size());
    std::vector<Index> group;
    for (Index count = 0, i = cut_ < 0 ? 0 : next(cut_); count < n; ++count, i = next(i)) {
      group.push_back(i);
      if (count + 1 < n && joined(i)) continue;
      balance(group);
      group.clear();
    }
    if (cut_ >= 0 && side(cut_) != 0) circulate();
  }

  // Where a loop is cut open for counting: a contact that carries no force, if there is one.
  // If there is none, the ratios round the loop cancel by themselves and any contact will do; the
  // one where the tension is least keeps the small forces near it free of rounding.
  void choose_cut() {
    cut_ = -1;
    if (!problem_.loop) return;
    const auto preference = [this](Index k) {
      const int kind = tied(problem_, k) ? 0 : side(k) == 0 ? 3 : problem_.slip(k) == 0 ? 2 : 1;
      return std::pair(kind, -u_(k));
    };
    cut_ = 0;
    for (Index k = 1; k < problem_.phi.size(); ++k)
      if (preference(k) > preference(cut_)) cut_ = k;
  }

  void balance(const std::vector<Index>& group) {
    Real level = 0, pulled = 0, weighed = 0;
    for (const Index i : group) {
      u_(i) = level;
      pulled += problem_.elastic(i);
      weighed += problem_.length(i) * std::exp(level);
      level -= bound(i);
    }
    // A group that nothing pulls falls until its neighbours hold it (the next repair).
    const Real shift = pulled > 0 ? std::log(pulled / weighed) : Real(-3000);
    for (const Index i : group) u_(i) += shift;
    for (std::size_t at = 0; at + 1 < group.size(); ++at) carry(group, at);
  }

  // u_i - u_{i+1} where the two are joined.
  Real bound(Index i) {
    return i < problem_.phi.size() ? static_cast<Real>(side(i)) * problem_.phi(i) : Real(0);
  }

  // Elastic force of the contact after group[at], summed from the end that is smaller.
  void carry(const std::vector<Index>& group, std::size_t at) {
    Real head = 0, tail = 0, head_size = 0, tail_size = 0;
    for (std::size_t j = 0; j < group.size(); ++j) {
      const Index i = group[j];
      const Real stretch = problem_.length(i) * std::exp(u_(i));
      (j <= at ? head : tail) += problem_.elastic(i) - stretch;
      (j <= at ? head_size : tail_size) += problem_.elastic(i) + stretch;
    }
    force_(group[at]) = head_size < tail_size ? head : -tail;
    noise_(group[at]) = tolerance * std::min(head_size, tail_size);
  }

  // A force round the whole loop, free where every contact is at its bound: the one that
  // violates the signs least.
  void circulate() {
    constexpr Real far = 1e300L;
    Real least = -far, most = far;
    for (Index k = 0; k < problem_.phi.size(); ++k) {
      if (tied(problem_, k) || problem_.slip(k) != 0) continue;
      if (side(k) > 0) least = std::max(least, -force_(k));
      if (side(k) < 0) most = std::min(most, -force_(k));
    }
    const Real circulation = least == -far ? std::min(most, Real(0))
                             : most == far ? std::max(least, Real(0))
                                           : (least + most) / 2;
    for (Index k = 0; k < problem_.phi.size(); ++k) force_(k) += circulation;
  }

  // Moves every contact that violates a condition to where it belongs.
  bool repair_all() {
    bool repaired = false;
    for (Index k = 0; k < problem_.phi.size(); ++k) {
      if (wanted(k) == side(k)) continue;
      side(k) = wanted(k);
      repaired = true;
    }
    return repaired;
  }

  bool repair_one() {
    Index wrong = -1, loose = -1;
    for (Index k = 0; k < problem_.phi.size(); ++k) {
      if (wanted(k) == side(k)) continue;
      Index& worst = side(k) != 0 || problem_.slip(k) != 0 ? wrong : loose;
      if (worst < 0 || excess(k) > excess(worst)) worst = k;
    }
    if (wrong >= 0)
      side(wrong) = wanted(wrong);
    else if (loose >= 0)
      close(loose);
    return wrong >= 0 || loose >= 0;
  }

  Real excess(Index k) {
    return side(k) != 0 ? std::abs(force_(k)) : std::abs(u_(k) - u_(next(k))) - problem_.phi(k);
  }

  // Ties the two groups at an open contact. If the force that it takes up would pull another
  // contact off its bound, the one that it pulls off first is opened in exchange.
  void close(Index k) {
    const int better = wanted(k);
    const Index first = first_to_open(k, better);
    side(k) = better;
    evaluate();
    for (Index other = 0; other < problem_.phi.size(); ++other)
      if (first >= 0 && side(other) != 0 && wanted(other) != side(other)) {
        side(first) = 0;
        return;
      }
  }

  Index first_to_open(Index k, int better) {
    const Index contacts = problem_.phi.size();
    Index first = -1;
    for (const Index stride : {Index(1), Index(-1)})
      for (Index at = k + stride; problem_.loop || (at >= 0 && at < contacts); at += stride) {
        const Index other = (at + contacts) % contacts;
        if (other == k || !joined(other)) break;
        if (side(other) != -better || problem_.slip(other) != 0) continue;
        if (first < 0 || std::abs(force_(other)) < std::abs(force_(first))) first = other;
      }
    return first;
  }

  // Where a contact belongs by the conditions that hold at it alone.
  int wanted(Index k) {
    if (tied(problem_, k)) return 0;
    const Real d = u_(k) - u_(next(k));
    const Real phi = problem_.phi(k), slip = problem_.slip(k);
    if (k == cut_ && side(k) != 0)
      return std::abs(d - static_cast<Real>(side(k)) * phi) < 1e-12L ? side(k) : 0;
    if (slip != 0) return slip < 0 ? 1 : -1;
    if (side(k) == 0) return std::abs(d) <= phi + tolerance ? 0 : d > 0 ? 1 : -1;
    return static_cast<Real>(side(k)) * force_(k) >= -noise_(k) ? side(k) : 0;
  }

  const Problem& problem_;
  Sides sides_;
  Index cut_ = -1;
  Vector u_, force_, noise_;
};

}  // namespace

Vector limit(const Problem& problem, Sides sides) {
  return Limit(problem, std::move(sides)).solve();
}

}  // namespace reeve::testing::reference
