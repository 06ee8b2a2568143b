#include "tests/support/reference_tree_interior.hpp"

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>

#include "tests/support/reference_groups.hpp"

namespace reeve::testing::reference {

namespace {

struct Open {
  std::size_t contact;
  Index left, right;  // groups
  Real offset;        // d = u_left - u_right + offset
  Real phi;
};

// Differences inside all cones, for the start: 0 at open contacts, and in a loop what cancels the
// known ones. Gives ln T of each segment; false where a loop has no inside.
bool start_levels(const Tree& tree, const std::vector<Real>& known, const std::vector<bool>& open,
                  Vector& level) {
  level = Vector::Zero(tree.length.size());
  for (const Span& span : tree.spans) {
    Real turned = 0, room = 0;
    for (Index k = span.contact; k < span.contact + span.contacts; ++k) {
      const auto at = static_cast<std::size_t>(k);
      turned += known[at];
      if (open[at]) room += tree.contacts[at].phi;
    }
    const Real share = span.loop && room > 0 ? -turned / room : Real(0);
    if (!(std::abs(share) < 1)) return false;
    for (Index j = 0; j + 1 < span.segments; ++j) {
      const auto at = static_cast<std::size_t>(span.contact + j);
      const Real difference = open[at] ? share * tree.contacts[at].phi : known[at];
      level(span.segment + j + 1) = level(span.segment + j) - difference;
    }
    auto levels = level.segment(span.segment, span.segments);
    levels.array() -= levels.maxCoeff();
  }
  return true;
}

class TreeInterior {
 public:
  explicit TreeInterior(const Tree& tree)
      : tree_(tree), groups_(gather(tree, known_by_kinematics(tree))) {
    find_open();
    const auto m = static_cast<Index>(open_.size());
    z_ = Vector::Zero(tree.hangs.cols());
    phi_.resize(m);
    for (Index k = 0; k < m; ++k) phi_(k) = open_[static_cast<std::size_t>(k)].phi;
  }

  std::optional<std::vector<Verdict>> solve() {
    if (open_.empty()) return std::vector<Verdict>{};
    if (!begin()) return std::nullopt;
    int settled = 0;
    for (int step = 0; step < limit && settled < 2; ++step) {
      const Vector carried = stretched();
      const Vector beside = smaller_side(carried);
      const Real gap = mean_gap(beside);
      const bool done = gap <= goal;
      const Vector even = (gap * beside).cwiseMin(mean_gap(Vector::Ones(beside.size())));
      const Real length = advance(carried, done ? even : centring_ * even);
      if (!(u_.minCoeff() > lost)) return std::nullopt;
      if (!(length > 0)) break;
      damping_ = length < 0.05L ? std::max(10 * damping_, 0.01L) : damping_ / 10;
      centring_ = length > 0.5L ? 0.1L : length > 0.1L ? 0.5L : 1;
      settled = done && length == 1 && change_ < 1e-6L ? settled + 1 : 0;
    }
    return verdicts();
  }

 private:
  static constexpr Real goal = 1e-12L;
  static constexpr int limit = 300;
  static constexpr Real farthest = 2;  // in ln T, by a step
  static constexpr Real lost = -300;   // ln T of what goes slack

  void find_open() {
    known_.assign(tree_.contacts.size(), 0);
    is_open_.assign(tree_.contacts.size(), true);
    for (const auto& [contact, difference] : known_by_kinematics(tree_)) {
      known_[contact] = difference;
      is_open_[contact] = false;
    }
    for (std::size_t k = 0; k < tree_.contacts.size(); ++k) {
      const auto& [left, right, phi, bar, arms, slip] = tree_.contacts[k];
      const Index l = groups_.of[static_cast<std::size_t>(left)];
      const Index r = groups_.of[static_cast<std::size_t>(right)];
      if (is_open_[k] && l != r)
        open_.push_back({k, l, r, groups_.rho(left) - groups_.rho(right), phi});
    }
  }

  bool begin() {
    Vector level;
    if (!start_levels(tree_, known_, is_open_, level)) return false;
    u_ = Vector::Zero(groups_.stretch.size());
    for (Index i = 0; i < level.size(); ++i)
      u_(groups_.of[static_cast<std::size_t>(i)]) = level(i) - groups_.rho(i);
    if (!(groups_.elastic.sum() > 0)) return false;
    u_.array() += std::log(groups_.elastic.sum() / stretched().sum());
    right_ = left_ = smaller_side(stretched()).cwiseQuotient(phi_);
    q_ = phi_ + differences(u_);
    p_ = phi_ - differences(u_);
    for (Index k = 0; k < phi_.size(); ++k) {
      q_(k) += open_[static_cast<std::size_t>(k)].offset;
      p_(k) -= open_[static_cast<std::size_t>(k)].offset;
    }
    return true;
  }

  Vector differences(const Vector& u) const {
    Vector d(phi_.size());
    for (Index k = 0; k < d.size(); ++k) {
      const Open& open = open_[static_cast<std::size_t>(k)];
      d(k) = u(open.left) - u(open.right);
    }
    return d;
  }

  Vector stretched() const { return groups_.stretch.array() * u_.array().exp(); }

  // Of the stretch on either side of each contact, by which its slip is small or not.
  Vector smaller_side(const Vector& carried) const {
    Vector smaller(phi_.size());
    for (Index k = 0; k < smaller.size(); ++k) {
      const Open& open = open_[static_cast<std::size_t>(k)];
      smaller(k) = std::min(carried(open.left), carried(open.right));
    }
    return smaller;
  }

  Real mean_gap(const Vector& beside) const {
    const Vector gaps = q_.cwiseProduct(right_) + p_.cwiseProduct(left_);
    return gaps.cwiseQuotient(beside).mean() / 2;
  }

  // The slips s out of the left group and into the right one, as lengths that each needs more.
  Vector spread(const Vector& s) const {
    Vector sum = Vector::Zero(u_.size());
    for (Index k = 0; k < s.size(); ++k) {
      sum(open_[static_cast<std::size_t>(k)].left) += s(k);
      sum(open_[static_cast<std::size_t>(k)].right) -= s(k);
    }
    return sum;
  }

  Matrix stiffness(const Vector& carried) const {
    Matrix k = carried.asDiagonal();
    for (Index at = 0; at < phi_.size(); ++at) {
      const Open& open = open_[static_cast<std::size_t>(at)];
      const Real w = right_(at) / q_(at) + left_(at) / p_(at);
      k(open.left, open.left) += w;
      k(open.right, open.right) += w;
      k(open.left, open.right) -= w;
      k(open.right, open.left) -= w;
    }
    return k;
  }

  // ln (sum of strands and beckets / sum of tails) of each block, and its gradient in u. A block
  // whose tendons are all slack is left where it is.
  Vector balances(Matrix& gradient) const {
    const Vector t = u_.array().exp();
    gradient = Matrix::Zero(z_.size(), u_.size());
    Vector off = Vector::Zero(z_.size());
    for (Index b = 0; b < z_.size(); ++b) {
      const Vector pull = groups_.pull.col(b).cwiseProduct(t);
      const Vector strands = pull.cwiseMax(0), tails = (-pull).cwiseMax(0);
      if (strands.sum() == 0 && tails.sum() == 0) continue;
      off(b) = std::log(strands.sum() / tails.sum());
      gradient.row(b) = strands / strands.sum() - tails / tails.sum();
    }
    return off;
  }

  Real advance(const Vector& carried, const Vector& target) {
    const Eigen::LLT<Matrix> factor(stiffness(carried));
    const Vector out = groups_.elastic + groups_.imposed * z_ +
                       spread(target.cwiseQuotient(q_) - target.cwiseQuotient(p_)) - carried;
    Matrix gradient;
    const Vector off = balances(gradient);
    const bool has_blocks = groups_.imposed.cols() > 0;
    const Matrix moved = has_blocks ? Matrix(factor.solve(groups_.imposed)) : groups_.imposed;
    const Vector alone = factor.solve(out);
    Matrix response = gradient * moved;
    for (Index b = 0; b < z_.size(); ++b)
      if (response.row(b).isZero(0)) response(b, b) = 1;
    response.diagonal().array() += damping_ * response.norm();
    const Vector dz = solved_for_blocks(response, -off - gradient * alone);
    const Vector du = alone + moved * dz;
    change_ = du.cwiseAbs().maxCoeff();
    return move(du.cwiseMax(-farthest).cwiseMin(farthest), dz, target);
  }

  Real move(const Vector& du, const Vector& dz, const Vector& target) {
    const Vector d = differences(du);
    const Vector right =
        (target.array() - right_.array() * d.array()) / q_.array() - right_.array();
    const Vector left = (target.array() + left_.array() * d.array()) / p_.array() - left_.array();
    const Real length =
        std::min({within(q_, d), within(p_, -d), within(right_, right), within(left_, left)});
    u_ += length * du;
    z_ += length * dz;
    q_ += length * d;
    p_ -= length * d;
    right_ += length * right;
    left_ += length * left;
    return length;
  }

  // The longest step, at most 1, that leaves a hundredth of each positive value.
  static Real within(const Vector& value, const Vector& change) {
    Real length = 1;
    for (Index i = 0; i < value.size(); ++i)
      if (change(i) < 0) length = std::min(length, -0.99L * value(i) / change(i));
    return length;
  }

  std::vector<Verdict> verdicts() const {
    const Vector beside = smaller_side(stretched());
    std::vector<Verdict> found;
    for (Index k = 0; k < phi_.size(); ++k) {
      const Real to_right = std::log(right_(k) / beside(k)) - std::log(q_(k) / phi_(k));
      const Real to_left = std::log(left_(k) / beside(k)) - std::log(p_(k) / phi_(k));
      const int side = to_right > 0 ? -1 : to_left > 0 ? 1 : 0;
      found.push_back(
          {open_[static_cast<std::size_t>(k)].contact, side, std::max(to_right, to_left)});
    }
    return found;
  }

  const Tree& tree_;
  const Groups groups_;
  std::vector<Real> known_;
  std::vector<bool> is_open_;
  std::vector<Open> open_;
  Real centring_ = 0.1L, change_ = 0;
  Real damping_ = 0;  // of the blocks, where a step led out of bounds
  Vector u_, z_, phi_;
  Vector q_, p_;         // rooms; kept, as differences of u would lose the small ones
  Vector right_, left_;  // s+, s-
};

}  // namespace

std::optional<std::vector<Verdict>> open_contacts(const Tree& tree) {
  return TreeInterior(tree).solve();
}

}  // namespace reeve::testing::reference
