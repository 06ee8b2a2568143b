#include "tests/support/reference_tree.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <stdexcept>
#include <string>

#include "tests/support/reference_motion.hpp"

namespace reeve::testing::reference {

namespace {

using Group = std::vector<std::size_t>;  // tendons, by their place in the word

std::set<std::string> blocks_of(const Tendon& tendon) {
  std::set<std::string> blocks;
  for (const BlockPass& pass : tendon.passes) blocks.insert(pass.block);
  for (const BlockEnd& end : tendon.ends) blocks.insert(end.block);
  return blocks;
}

std::vector<Group> joined_tendons(const std::vector<Tendon>& tendons) {
  std::vector<std::size_t> root(tendons.size());
  std::iota(root.begin(), root.end(), std::size_t{0});
  std::map<std::string, std::size_t> first;
  for (std::size_t t = 0; t < tendons.size(); ++t) {
    for (const std::string& block : blocks_of(tendons[t])) {
      const std::size_t other = root[first.emplace(block, t).first->second];
      const std::size_t mine = root[t];
      std::replace(root.begin(), root.end(), std::max(mine, other), std::min(mine, other));
    }
  }
  std::map<std::size_t, Group> groups;
  for (std::size_t t = 0; t < tendons.size(); ++t) groups[root[t]].push_back(t);
  std::vector<Group> found;
  for (auto& [at, group] : groups) found.push_back(std::move(group));
  return found;
}

[[noreturn]] void ill_formed(const std::string& block, const std::string& what) {
  throw std::invalid_argument("the reference model: block " + block + " " + what);
}

void check_blocks(const std::vector<Tendon>& tendons) {
  std::map<std::string, int> tails, heads, bar_passes;
  for (const Tendon& tendon : tendons) {
    std::set<std::string> above;
    for (const BlockEnd& end : tendon.ends) {
      ++(end.becket ? heads : tails)[end.block];
      if (!end.becket) above.insert(end.block);
    }
    for (const BlockPass& pass : tendon.passes) {
      ++heads[pass.block];
      if (pass.bar && ++bar_passes[pass.block] > 1) ill_formed(pass.block, "has but two arms");
      if (above.contains(pass.block)) ill_formed(pass.block, "hangs on itself");
      if (pass.bar && tendon.loop && pass.left != pass.right)
        ill_formed(pass.block, "has unequal arms in a loop");
    }
    for (const BlockEnd& end : tendon.ends)
      if (end.becket && above.contains(end.block)) ill_formed(end.block, "hangs on itself");
  }
  for (const auto& [block, count] : heads)
    if (tails[block] == 0) ill_formed(block, "has no tail");
  for (const auto& [block, count] : tails)
    if (count > 0 && heads[block] == 0) ill_formed(block, "has neither pass nor becket");
}

class TreeBuilder {
 public:
  TreeBuilder(const std::vector<Tendon>& tendons, const ReferenceHardware& hardware)
      : tendons_(tendons), hardware_(hardware) {}

  Tree build(const Group& group) {
    tree_ = {};
    std::set<std::string> names;
    Index segments = 0;
    for (const std::size_t t : group) {
      segments += static_cast<Index>(tendons_[t].segments.size());
      names.merge(blocks_of(tendons_[t]));
    }
    tree_.length = tree_.strand = tree_.motor = Vector::Zero(segments);
    tree_.give = tree_.elastic = tree_.motor;
    tree_.c = Vector::Ones(segments);
    tree_.hangs = Matrix::Zero(segments, static_cast<Index>(names.size()));
    blocks_.assign(names.begin(), names.end());
    for (const std::size_t t : group) add(t);
    return std::move(tree_);
  }

 private:
  Index block(const std::string& name) const {
    return std::find(blocks_.begin(), blocks_.end(), name) - blocks_.begin();
  }

  void add(std::size_t t) {
    const Tendon& tendon = tendons_[t];
    const Span span{t,
                    static_cast<Index>(tree_.finger.size()),
                    static_cast<Index>(tendon.segments.size()),
                    static_cast<Index>(tree_.contacts.size()),
                    static_cast<Index>(tendon.kinds.size()),
                    tendon.loop};
    tree_.spans.push_back(span);
    tree_.length.segment(span.segment, span.segments) = lengths(tendon, hardware_);
    for (Index i = 0; i < span.segments; ++i) {
      const Segment& segment = tendon.segments[static_cast<std::size_t>(i)];
      tree_.finger.push_back(segment.finger);
      tree_.strand(span.segment + i) = segment.finger == 0 ? 0 : segment.extensor ? -1 : 1;
      tree_.motor_side.push_back(segment.place == Place::motor_side);
      tree_.motor(span.segment + i) = travel(segment, hardware_);
    }
    add_contacts(tendon, span);
    hang(tendon, span);
  }

  void add_contacts(const Tendon& tendon, const Span& span) {
    const Vector phi = exponents(tendon, hardware_);
    for (Index k = 0; k < span.contacts; ++k)
      tree_.contacts.push_back(
          {span.segment + k, span.segment + (k + 1) % span.segments, phi(k), false, 0});
    for (const BlockPass& pass : tendon.passes) {
      if (!pass.bar) continue;
      const auto k = static_cast<Index>(pass.contact);
      const auto at = static_cast<std::size_t>(span.contact + k);
      tree_.contacts[at].bar = true;
      tree_.contacts[at].arms = std::log(static_cast<Real>(pass.left) / pass.right);
      if (!tendon.loop)
        tree_.c.segment(span.segment + k + 1, span.segments - k - 1) *=
            static_cast<Real>(pass.right) / pass.left;
    }
  }

  void hang(const Tendon& tendon, const Span& span) {
    for (const BlockPass& pass : tendon.passes) {
      const auto k = static_cast<Index>(pass.contact);
      for (const Index i : {k, (k + 1) % span.segments})
        tree_.hangs(span.segment + i, block(pass.block)) += 1;
    }
    for (const BlockEnd& end : tendon.ends)
      tree_.hangs(span.segment + static_cast<Index>(end.segment), block(end.block)) +=
          end.becket ? 1 : -1;
  }

  const std::vector<Tendon>& tendons_;
  const ReferenceHardware& hardware_;
  std::vector<std::string> blocks_;
  Tree tree_;
};

// Slips that cancel e0: 0 = c_i e0_i + s_i - s_{i-1}. Rounding must not turn rest into motion.
void set_slips(const Vector& e0, Tree& tree) {
  for (const Span& span : tree.spans) {
    Vector slip(span.contacts), phi(span.contacts);
    Real sum = 0, size = 0;
    for (Index k = 0; k < span.contacts; ++k) {
      const Index i = span.segment + k;
      slip(k) = -(sum += tree.c(i) * e0(i));
      phi(k) = tree.contacts[static_cast<std::size_t>(span.contact + k)].phi;
    }
    for (Index i = span.segment; i < span.segment + span.segments; ++i)
      size += tree.c(i) * std::abs(e0(i));
    if (span.loop) slip.array() += median_circulation(phi, slip);
    for (Index k = 0; k < span.contacts; ++k)
      if (std::abs(slip(k)) > 1e-14L * (1 + size))
        tree.contacts[static_cast<std::size_t>(span.contact + k)].slip = slip(k);
  }
}

void impose_jam(ReferenceDirection direction, Tree& tree) {
  tree.jams = true;
  const bool pull = direction == ReferenceDirection::pull;
  for (Index i = 0; i < tree.length.size(); ++i) {
    const bool hand_side = !tree.motor_side[static_cast<std::size_t>(i)];
    tree.elastic(i) = pull ? tree.motor(i) : hand_side ? tree.length(i) : Real(0);
  }
}

void impose_motion(const Motion& found, ReferenceDirection direction, Tree& tree) {
  const Real sign = direction == ReferenceDirection::pull ? 1 : -1;
  tree.closing = found.closing;
  for (Index i = 0; i < tree.give.size(); ++i) {
    const auto finger = tree.closing.find(tree.finger[static_cast<std::size_t>(i)]);
    if (finger != tree.closing.end()) tree.give(i) = tree.strand(i) * finger->second;
  }
  tree.slack = found.slack;
  Vector imposed = sign * (tree.give - tree.motor);
  Vector gap =
      tree.hangs.cols() > 0 ? Vector(sign * tree.hangs * found.z - imposed) : Vector(-imposed);
  for (std::size_t t = 0; t < tree.slack.size(); ++t) {
    if (!tree.slack[t]) continue;
    imposed.segment(tree.spans[t].segment, tree.spans[t].segments).setZero();
    gap.segment(tree.spans[t].segment, tree.spans[t].segments).setZero();
  }
  tree.elastic = imposed.cwiseMax(0);
  set_slips(gap, tree);
}

std::map<int, Real> closing_weights(const Tree& tree, const std::set<int>& held,
                                    const ReferenceHardware& hardware) {
  std::map<int, Real> weights;
  for (const int finger : tree.finger)
    if (finger != 0 && !held.contains(finger) && weight(finger, hardware) > 0)
      weights[finger] = weight(finger, hardware);
  return weights;
}

}  // namespace

std::vector<Tree> pose_trees(const std::vector<Tendon>& tendons, const std::set<int>& held,
                             ReferenceDirection direction, const ReferenceHardware& hardware) {
  check_blocks(tendons);
  std::vector<Tree> trees;
  for (const Group& group : joined_tendons(tendons)) {
    Tree tree = TreeBuilder(tendons, hardware).build(group);
    if (std::count(tree.motor_side.begin(), tree.motor_side.end(), true) == 0)
      throw std::invalid_argument("the reference model: a tree has no motor-side segment");
    Real loose = 0;
    for (const std::size_t t : group) loose += slack(tendons[t], hardware);
    if (loose > 0 && tree.motor.sum() <= loose) {
      trees.push_back(std::move(tree));
      continue;
    }
    const Motion found = motion(tree, closing_weights(tree, held, hardware));
    if (found.possible)
      impose_motion(found, direction, tree);
    else
      impose_jam(direction, tree);
    if (loose > 0) tree.elastic *= 1 - loose / tree.motor.sum();
    trees.push_back(std::move(tree));
  }
  return trees;
}

std::vector<Tree> pose_shared(const std::vector<Tendon>& tendons, const SharedMotion& shared,
                              ReferenceDirection direction, const ReferenceHardware& hardware) {
  std::vector<Tree> trees;
  for (std::size_t t = 0; t < tendons.size(); ++t) {
    trees.push_back(TreeBuilder(tendons, hardware).build({t}));
    if (shared.slack[t])
      trees.back().closing = shared.closing;
    else
      impose_motion({true, shared.closing, Vector()}, direction, trees.back());
  }
  return trees;
}

}  // namespace reeve::testing::reference
