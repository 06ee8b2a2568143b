#include "core/tension/tree_tension.hpp"

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>

namespace reeve::core {
namespace {

// Conditions are inequalities between rounded sums and products.
constexpr double rounding = 1e-12;
// Exchanging all at once ends after a few rounds or goes in circles.
constexpr int most_rounds = 60;
constexpr int most_steps = 5000;

using Matrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, block_keys, block_keys>;

}  // namespace

void TreeTension::find_loops(const Network& network, const Mechanics& mechanics,
                             const Motion& motion, std::size_t tree) {
  loops_.clear();
  openings_.clear();
  for (std::size_t t = 0; t < network.tendons.size(); ++t) {
    const TendonSpan& tendon = network.tendons[t];
    if (tendon.tree != tree || !tendon.closed || motion.is_slack(t)) continue;
    const std::size_t first = openings_.size();
    for (std::size_t k = 0; k < tendon.contacts; ++k) {
      const std::size_t contact = tendon.first_contact + k;
      if (slide_at(network, mechanics, motion, tendon, contact) == Slide::no) {
        openings_.push_back(k);
      }
    }
    loops_.push_back({t, first, openings_.size(), first});
  }
}

bool TreeTension::next_openings() {
  for (Loop& loop : loops_) {
    if (++loop.chosen < loop.end_opening) return true;
    loop.chosen = loop.first_opening;
  }
  return false;
}

void TreeTension::add_pulls(const Network& network, const TendonSpan& tendon, std::size_t i) {
  const auto at_end = [&](const TendonEnd& end) {
    if (end.tie != EndTie::none) {
      pulls_.push_back({end.block, end.tie == EndTie::tail ? -1.0 : 1.0});
    }
  };
  const auto at_contact = [&](std::size_t k) {
    const std::size_t block = network.contacts[tendon.first_contact + k].block;
    if (block != no_block) pulls_.push_back({block, 1.0});
  };
  if (i == 0) at_end(tendon.left);
  if (i > 0 || tendon.closed) at_contact(i > 0 ? i - 1 : tendon.contacts - 1);
  if (i < tendon.contacts) at_contact(i);
  if (i + 1 == tendon.segments) at_end(tendon.right);
}

void TreeTension::add_chain(const Network& network, const Mechanics& mechanics,
                            const Motion& motion, const TendonSpan& tendon, std::size_t first) {
  const std::size_t n = tendon.segments;
  chains_.push_back({cells_.size(), cells_.size() + n, pulls_.size()});
  for (std::size_t j = 0; j < n; ++j) {
    const std::size_t i = (first + j) % n;
    Cell cell;
    cell.segment = tendon.first_segment + i;
    cell.length = mechanics.length[cell.segment];
    cell.take_up = motion.take_up[cell.segment];
    add_pulls(network, tendon, i);
    cell.pulls = pulls_.size();
    if (j + 1 < n) {
      const std::size_t k = tendon.first_contact + i;
      const Contact& contact = network.contacts[k];
      cell.decay = mechanics.decay[k];
      const Slide slide = slide_at(network, mechanics, motion, tendon, k);
      if (contact.kind == ContactKind::bar) {
        const ArmRatio& arms = network.blocks[contact.block].arms;
        cell.is_bar = true;
        cell.arms = static_cast<double>(arms.left) / arms.right;
        cell.link = Link::ratio;
        cell.ratio = 1 / cell.arms;
      } else if (slide != Slide::no || cell.decay == 1) {
        cell.link = Link::ratio;
        cell.ratio = slide == Slide::to_right ? 1 / cell.decay : cell.decay;
      } else {
        cell.link = Link::stick;
      }
    }
    cells_.push_back(cell);
  }
}

void TreeTension::build(const Network& network, const Mechanics& mechanics, const Motion& motion,
                        std::size_t tree) {
  cells_.clear();
  pulls_.clear();
  chains_.clear();
  auto loop = loops_.begin();
  for (std::size_t t = 0; t < network.tendons.size(); ++t) {
    const TendonSpan& tendon = network.tendons[t];
    if (tendon.tree != tree || motion.is_slack(t)) continue;
    std::size_t first = 0;
    if (tendon.closed) {
      first = (openings_[loop->chosen] + 1) % tendon.segments;
      ++loop;
    }
    add_chain(network, mechanics, motion, tendon, first);
  }
  travel_.assign(network.blocks.size(), 0);
  in_tree_.clear();
  for (const Pull& pull : pulls_) {
    if (std::find(in_tree_.begin(), in_tree_.end(), pull.block) == in_tree_.end()) {
      in_tree_.push_back(pull.block);
    }
  }
}

TreeTension::Run TreeTension::sum_up(std::size_t first_cell, std::size_t& pull, Vector& force,
                                     Vector& gain) {
  Run run{first_cell};
  double relative = 1;
  double weight = 1;
  force.setZero();
  gain.setZero();
  while (true) {
    Cell& cell = cells_[run.end_cell++];
    cell.relative = relative;
    run.stiff += weight * cell.length * relative;
    run.take_up += weight * cell.take_up;
    for (; pull < cell.pulls; ++pull) {
      const auto b = std::find(in_tree_.begin(), in_tree_.end(), pulls_[pull].block);
      force(b - in_tree_.begin()) += pulls_[pull].sign * relative;
      gain(b - in_tree_.begin()) += pulls_[pull].sign * weight;
    }
    if (cell.link == Link::none || cell.link == Link::stick) return run;
    if (cell.is_bar) weight /= cell.arms;
    relative *= cell.link == Link::ratio            ? cell.ratio
                : cell.link == Link::creep_to_right ? 1 / cell.decay
                                                    : cell.decay;
  }
}

// Calls visit(first cell, run, β, c) for each run of each taut tendon.
template <typename Visit>
void TreeTension::for_each_run(Visit visit) {
  const auto m = static_cast<Eigen::Index>(in_tree_.size());
  Vector force(m);
  Vector gain(m);
  for (const Chain& chain : chains_) {
    if (chain.slack) continue;
    std::size_t pull = chain.first_pull;
    for (std::size_t cell = chain.first_cell; cell < chain.end_cell;) {
      const Run run = sum_up(cell, pull, force, gain);
      visit(cell, run, force, gain);
      cell = run.end_cell;
    }
  }
}

// With sticks and creeps as they stand, each run has one unknown tension t, and each block a
// balance Σ β t = 0. Eliminating t leaves the blocks.
void TreeTension::solve_linear() {
  const auto m = static_cast<Eigen::Index>(in_tree_.size());
  Matrix matrix = Matrix::Zero(m, m);
  Vector right = Vector::Zero(m);
  for_each_run([&](std::size_t, const Run& run, const Vector& force, const Vector& gain) {
    matrix += force * gain.transpose() / run.stiff;
    right -= force * (run.take_up / run.stiff);
  });
  for (Eigen::Index b = 0; b < m; ++b) {
    if (matrix(b, b) == 0) matrix(b, b) = 1;  // all its tendons are slack: it stays where it is
  }
  Vector travel(m);
  if (m > 0) travel = matrix.partialPivLu().solve(right);
  for_each_run([&](std::size_t first, const Run& run, const Vector&, const Vector& gain) {
    const double tension = (run.take_up + gain.dot(travel)) / run.stiff;
    for (std::size_t i = first; i < run.end_cell; ++i) {
      cells_[i].tension = tension * cells_[i].relative;
    }
  });
  scale_ = m > 0 ? travel.cwiseAbs().maxCoeff() : 0;
  for (const Cell& cell : cells_) scale_ = std::max(scale_, std::abs(cell.take_up));
  for (Eigen::Index b = 0; b < m; ++b) travel_[in_tree_[static_cast<std::size_t>(b)]] = travel(b);
}

// Returns the stretch of the whole tendon; below 0 it is slack.
double TreeTension::room(const Chain& chain) const {
  std::size_t pull = chain.first_pull;
  double weight = 1;
  double stretch = 0;
  for (std::size_t i = chain.first_cell; i < chain.end_cell; ++i) {
    const Cell& cell = cells_[i];
    stretch += weight * cell.take_up;
    for (; pull < cell.pulls; ++pull) {
      stretch += weight * pulls_[pull].sign * travel_[pulls_[pull].block];
    }
    if (cell.is_bar) weight /= cell.arms;
  }
  return std::abs(stretch) <= rounding * scale_ ? 0 : stretch;
}

void TreeTension::find_wrong_links(const Chain& chain) {
  double slip = 0;
  double size = 0;  // sum of the same lengths as slip, without signs
  std::size_t pull = chain.first_pull;
  for (std::size_t i = chain.first_cell; i < chain.end_cell; ++i) {
    const Cell& cell = cells_[i];
    double take_up = cell.take_up;
    for (; pull < cell.pulls; ++pull) take_up += pulls_[pull].sign * travel_[pulls_[pull].block];
    slip += cell.length * cell.tension - take_up;
    size += std::abs(cell.length * cell.tension) + std::abs(take_up);
    Link wanted = cell.link;
    if (cell.link == Link::stick) {
      const double right = cells_[i + 1].tension;
      const double margin = rounding * (std::abs(cell.tension) + std::abs(right));
      if (cell.tension < cell.decay * right - margin) wanted = Link::creep_to_right;
      if (right < cell.decay * cell.tension - margin) wanted = Link::creep_to_left;
      slip = size = 0;
    } else if ((cell.link == Link::creep_to_right && slip < -rounding * size) ||
               (cell.link == Link::creep_to_left && slip > rounding * size)) {
      wanted = Link::stick;
    }
    if (cell.is_bar) slip *= cell.arms;
    if (wanted != cell.link) exchanges_.push_back({i, wanted, false});
  }
}

// Finds the links and tendons that violate their conditions. Slack comes last: while links are
// wrong, tendons only seem to be left room.
void TreeTension::find_exchanges() {
  exchanges_.clear();
  for (const Chain& chain : chains_) {
    if (!chain.slack) find_wrong_links(chain);
  }
  if (!exchanges_.empty()) return;
  for (std::size_t c = 0; c < chains_.size(); ++c) {
    const double stretch = room(chains_[c]);
    if (chains_[c].slack ? stretch > 0 : stretch < 0) exchanges_.push_back({c, Link::none, true});
  }
}

void TreeTension::apply(const Exchange& exchange) {
  if (exchange.of_chain) {
    chains_[exchange.at].slack = !chains_[exchange.at].slack;
  } else {
    cells_[exchange.at].link = exchange.link;
  }
}

bool TreeTension::write(std::vector<double>& tension) const {
  bool in_range = true;
  for (const Chain& chain : chains_) {
    const bool taut = room(chain) > 0;
    for (std::size_t i = chain.first_cell; i < chain.end_cell; ++i) {
      tension[cells_[i].segment] = taut ? cells_[i].tension : 0;
      in_range &= !taut || std::isnormal(cells_[i].tension);
    }
  }
  return in_range;
}

bool TreeTension::settle() {
  std::uint64_t draw = 1;
  for (int round = 0; round < most_rounds + most_steps; ++round) {
    solve_linear();
    find_exchanges();
    if (exchanges_.empty()) return true;
    if (round < most_rounds && !exchanges_.front().of_chain) {
      for (const Exchange& exchange : exchanges_) apply(exchange);
    } else {
      // Any fixed order can go in circles where the equations are not symmetric.
      draw = draw * 6364136223846793005U + 1442695040888963407U;
      apply(exchanges_[(draw >> 33U) % exchanges_.size()]);
    }
  }
  return false;
}

bool TreeTension::loops_fit(const Network& network, const Mechanics& mechanics,
                            const std::vector<double>& tension) const {
  return std::all_of(loops_.begin(), loops_.end(), [&](const Loop& loop) {
    const TendonSpan& tendon = network.tendons[loop.tendon];
    const std::size_t k = openings_[loop.chosen];
    const auto [left, right] = ends_of(tendon, k);
    const auto [low, high] = std::minmax(tension[left], tension[right]);
    return high * mechanics.decay[tendon.first_contact + k] <= low * (1 + rounding);
  });
}

bool TreeTension::solve(const Network& network, const Mechanics& mechanics, const Motion& motion,
                        std::size_t tree, std::vector<double>& tension) {
  find_loops(network, mechanics, motion, tree);
  do {
    build(network, mechanics, motion, tree);
    if (!settle()) continue;
    if (!write(tension)) return false;
    if (loops_fit(network, mechanics, tension)) return true;
  } while (next_openings());
  return false;
}

}  // namespace reeve::core
