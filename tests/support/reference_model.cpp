#include "tests/support/reference_model.hpp"

#include <Eigen/Dense>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <sstream>
#include <stdexcept>
#include <utility>

namespace reeve::testing {
namespace {

using Real = long double;
using Vector = Eigen::Matrix<Real, Eigen::Dynamic, 1>;
using Matrix = Eigen::Matrix<Real, Eigen::Dynamic, Eigen::Dynamic>;
using Index = Eigen::Index;

// ---- the word: tokens -> segments and contacts ----

enum class Place { strand, motor_side, hand };

struct Segment {
  std::string name;
  Place place;
  int finger;  // 0 if it is no strand
};

struct Tendon {
  std::vector<Segment> segments;
  std::vector<std::string> kinds;  // of contact k, between segments k and k + 1 (cyclically)
  std::set<int> fingers;
  bool loop = false;
};

std::vector<std::string> split(const std::string& text, char separator) {
  std::vector<std::string> parts;
  std::istringstream stream(text);
  for (std::string part; std::getline(stream, part, separator);) parts.push_back(part);
  return parts;
}

int finger_of(const std::string& token) {
  return std::isdigit(static_cast<unsigned char>(token.at(0))) ? std::stoi(token) : 0;
}

std::string tip_kind(const std::string& token) { return token.back() == 'b' ? "bearing" : "tube"; }

// 0 -> a, 25 -> z, 26 -> aa, ...
std::string letters(int number) {
  std::string name;
  for (int rest = number + 1; rest > 0; rest = (rest - 1) / 26)
    name.insert(name.begin(), static_cast<char>('a' + (rest - 1) % 26));
  return name;
}

class Reader {
 public:
  std::vector<Tendon> read(const std::string& word) {
    std::vector<Tendon> tendons;
    for (const auto& walk : split(word, '+')) tendons.push_back(read_walk(split(walk, '-')));
    return tendons;
  }

 private:
  Tendon read_walk(const std::vector<std::string>& tokens) {
    Tendon tendon;
    tendon.loop =
        tokens.size() > 1 && finger_of(tokens.front()) != 0 && tokens.front() == tokens.back();
    if (tokens.front() == "M") {
      tendon.segments.push_back(motor_side());
      tendon.kinds.emplace_back("sheath");
    }
    for (std::size_t i = 0; i + 1 < tokens.size(); ++i) {
      if (i > 0) pass(tokens[i], tendon);
      tendon.segments.push_back(stretch(tokens[i], tokens[i + 1]));
    }
    if (tokens.back() == "M") {
      tendon.kinds.emplace_back("sheath");
      tendon.segments.push_back(motor_side());
    }
    if (tendon.loop) tendon.kinds.push_back(tip_kind(tokens.front()));
    for (const auto& segment : tendon.segments)
      if (segment.finger != 0) tendon.fingers.insert(segment.finger);
    return tendon;
  }

  void pass(const std::string& token, Tendon& tendon) {
    if (finger_of(token) != 0) {
      tendon.kinds.push_back(tip_kind(token));
    } else if (token == "T") {
      tendon.kinds.emplace_back("tube");
    } else if (token == "B") {
      tendon.kinds.emplace_back("bearing");
    } else if (token == "P") {
      for (const char* kind : {"sheath", "bearing", "sheath"}) tendon.kinds.emplace_back(kind);
      for (int side = 0; side < 2; ++side) tendon.segments.push_back(motor_side());
    } else {
      throw std::invalid_argument("the reference model does not know the token " + token);
    }
  }

  Segment motor_side() { return {letters(motor_sides_++), Place::motor_side, 0}; }

  Segment stretch(const std::string& before, const std::string& after) {
    if (const int f = finger_of(before)) return {"T" + std::to_string(2 * f), Place::strand, f};
    if (const int f = finger_of(after)) return {"T" + std::to_string(2 * f - 1), Place::strand, f};
    return {"h" + std::to_string(++hands_), Place::hand, 0};
  }

  int motor_sides_ = 0;
  int hands_ = 0;
};

// ---- one tendon's problem, in numbers ----

struct Problem {
  bool loop = false;
  bool jams = false;
  Vector length, elastic, phi;    // L, E, phi
  Vector slip;                    // zero-order slip of each contact, D = 1
  std::map<int, double> closing;  // of the fingers that close
};

constexpr Real tied_phi = 1e-15L;  // below it a contact is taken as frictionless

bool tied(const Problem& problem, Index k) { return problem.phi(k) < tied_phi; }

Real nominal_phi(const std::string& kind, const ReferenceHardware& hardware) {
  const ReferenceLaw& law = kind == "tube"      ? hardware.tube
                            : kind == "bearing" ? hardware.bearing
                                                : hardware.sheath;
  return law.mu * law.angle;
}

Vector exponents(const Tendon& tendon, const ReferenceHardware& hardware) {
  Vector phi(static_cast<Index>(tendon.kinds.size()));
  for (std::size_t k = 0; k < tendon.kinds.size(); ++k) {
    const auto nominal = static_cast<double>(nominal_phi(tendon.kinds[k], hardware));
    const auto& left = tendon.segments[k].name;
    const auto& right = tendon.segments[(k + 1) % tendon.segments.size()].name;
    phi(static_cast<Index>(k)) =
        hardware.phi_override ? hardware.phi_override(left, right, nominal) : nominal;
  }
  return phi;
}

Vector lengths(const Tendon& tendon, const ReferenceHardware& hardware) {
  Vector length(static_cast<Index>(tendon.segments.size()));
  for (std::size_t i = 0; i < tendon.segments.size(); ++i) {
    const auto& [name, place, finger] = tendon.segments[i];
    const double nominal = place == Place::strand       ? hardware.strand_length
                           : place == Place::motor_side ? hardware.motor_side_length
                                                        : hardware.hand_length;
    length(static_cast<Index>(i)) =
        hardware.length_override ? hardware.length_override(name, nominal) : nominal;
  }
  return length;
}

// The c that minimises sum_k phi_k |slip_k + c|; the middle of them all if there are many.
Real median_circulation(const Vector& phi, const Vector& slip) {
  std::vector<std::pair<Real, Real>> points;
  for (Index k = 0; k < phi.size(); ++k)
    if (phi(k) >= tied_phi) points.emplace_back(-slip(k), phi(k));
  if (points.empty()) return 0;
  std::sort(points.begin(), points.end());
  const Real total = phi.sum();
  Real below = 0;
  std::size_t at = 0;
  while (below + points[at].second < total / 2 - 1e-14L * total) below += points[at++].second;
  const bool tie = below + points[at].second <= total / 2 + 1e-14L * total;
  const std::size_t next = std::min(at + 1, points.size() - 1);
  return tie ? (points[at].first + points[next].first) / 2 : points[at].first;
}

// Slips that cancel e0: 0 = e0_i + s_i - s_{i-1}. Rounding must not turn rest into motion.
Vector zero_order_slips(const Vector& e0, const Vector& phi, bool loop) {
  Vector slip(phi.size());
  Real sum = 0;
  for (Index k = 0; k < slip.size(); ++k) slip(k) = -(sum += e0(k));
  if (loop) slip.array() += median_circulation(phi, slip);
  const Real noise = 1e-16L * e0.cwiseAbs().sum();
  return slip.unaryExpr([noise](Real s) { return std::abs(s) <= noise ? Real(0) : s; });
}

double weight(int finger, const ReferenceHardware& hardware) {
  const auto found = hardware.closing_weight.find(finger);
  return found == hardware.closing_weight.end() ? 1.0 : found->second;
}

void impose_jam(const Tendon& tendon, ReferenceDirection direction, Problem& problem) {
  problem.jams = true;
  problem.slip.setZero(problem.phi.size());
  for (Index i = 0; i < problem.elastic.size(); ++i) {
    const bool motor_side = tendon.segments[static_cast<std::size_t>(i)].place == Place::motor_side;
    const bool pull = direction == ReferenceDirection::pull;
    problem.elastic(i) = motor_side != pull ? Real(0) : pull ? Real(1) : problem.length(i);
  }
}

// e0 is built in units of 1 / (2 total weight), in which it is exact, and divided afterwards.
void impose_motion(const Tendon& tendon, const std::map<int, Real>& weights, Real motor_sides,
                   ReferenceDirection direction, Problem& problem) {
  const bool pull = direction == ReferenceDirection::pull;
  Real unit = 0;
  for (const auto& [finger, w] : weights) unit += 2 * w;
  Vector e0 = Vector::Zero(problem.elastic.size());
  for (Index i = 0; i < e0.size(); ++i) {
    const auto& [name, place, finger] = tendon.segments[static_cast<std::size_t>(i)];
    const auto closing = weights.find(finger);
    if (place == Place::motor_side) {
      e0(i) = pull ? unit : -unit;
      problem.elastic(i) = pull ? 0 : 1;
    } else if (closing != weights.end()) {
      const Real give = motor_sides * closing->second;
      e0(i) = pull ? -give : give;
      problem.elastic(i) = pull ? give / unit : 0;
      problem.closing[finger] = static_cast<double>(give / unit);
    }
  }
  problem.slip = zero_order_slips(e0, problem.phi, problem.loop) / unit;
}

Problem pose(const Tendon& tendon, const std::set<int>& held, ReferenceDirection direction,
             const ReferenceHardware& hardware) {
  Problem problem;
  problem.loop = tendon.loop;
  problem.length = lengths(tendon, hardware);
  problem.phi = exponents(tendon, hardware);
  problem.elastic = Vector::Zero(problem.length.size());
  const auto motor_sides =
      std::count_if(tendon.segments.begin(), tendon.segments.end(),
                    [](const Segment& s) { return s.place == Place::motor_side; });
  if (motor_sides == 0) throw std::invalid_argument("a tendon has no motor-side segment");
  std::map<int, Real> weights;
  for (const int finger : tendon.fingers)
    if (!held.contains(finger) && weight(finger, hardware) > 0)
      weights[finger] = weight(finger, hardware);
  if (weights.empty())
    impose_jam(tendon, direction, problem);
  else
    impose_motion(tendon, weights, static_cast<Real>(motor_sides), direction, problem);
  return problem;
}

// ---- interior point: which contacts are at a bound ----

// +1: u_left - u_right = phi; -1: = -phi; 0: inside.
using Sides = std::vector<int>;

// Primal-dual interior-point method in the differences d_k = u_left - u_right. The common level of
// a tendon is eliminated by sum_i L_i T_i = S = sum_i E_i, which leaves, with y_i = u_i - u_0,
//
//   minimise S ln(sum_i L_i e^{y_i}) - sum_i E_i y_i + sum_k slip_k d_k / eps,  |d_k| <= phi_k,
//
// and for a loop sum_k d_k = 0. Frictionless contacts (d = 0) are no unknowns.
class InteriorPoint {
 public:
  explicit InteriorPoint(const Problem& problem) : problem_(problem) {
    for (Index k = 0; k < problem.phi.size(); ++k)
      if (!tied(problem, k)) free_.push_back(k);
    const auto m = static_cast<Index>(free_.size());
    phi_.resize(m);
    for (Index j = 0; j < m; ++j) phi_(j) = problem.phi(contact(j));
    d_.setZero(m);
    upper_room_ = lower_room_ = phi_;
    upper_force_ = lower_force_ = phi_.cwiseInverse() * start;
  }

  Sides solve() {
    if (free_.empty()) return Sides(static_cast<std::size_t>(problem_.phi.size()), 0);
    for (int step = 0; step < 300 && gap() > goal * problem_.elastic.sum(); ++step) advance();
    return sides();
  }

 private:
  static constexpr Real eps = 1e-8L;
  static constexpr Real start = 1 / eps;
  static constexpr Real goal = 1e-26L;

  Index contact(Index j) const { return free_[static_cast<std::size_t>(j)]; }

  Real gap() const {
    return (upper_room_.dot(upper_force_) + lower_room_.dot(lower_force_)) /
           static_cast<Real>(2 * phi_.size());
  }

  // Share of sum L T in the segments up to each contact, and beyond it.
  void weigh(Vector& head, Vector& tail) const {
    const Index n = problem_.length.size();
    Vector y = Vector::Zero(n);
    Vector difference = Vector::Zero(problem_.phi.size());
    for (Index j = 0; j < phi_.size(); ++j) difference(contact(j)) = d_(j);
    for (Index i = 1; i < n; ++i) y(i) = y(i - 1) - difference(i - 1);
    Vector share = problem_.length.array() * (y.array() - y.maxCoeff()).exp();
    share /= share.sum();
    head.resize(phi_.size());
    tail.resize(phi_.size());
    for (Index j = 0; j < phi_.size(); ++j) {
      head(j) = share.head(contact(j) + 1).sum();
      tail(j) = share.tail(n - 1 - contact(j)).sum();
    }
  }

  Vector gradient(const Vector& head, const Vector& tail) const {
    const Real total = problem_.elastic.sum();
    const Index n = problem_.length.size();
    Vector g(phi_.size());
    for (Index j = 0; j < g.size(); ++j) {
      const Index k = contact(j);
      const Real flux = head(j) < tail(j)
                            ? total * head(j) - problem_.elastic.head(k + 1).sum()
                            : problem_.elastic.tail(n - 1 - k).sum() - total * tail(j);
      g(j) = flux + problem_.slip(k) / eps;
    }
    return g;
  }

  Matrix hessian(const Vector& head, const Vector& tail) const {
    const Real total = problem_.elastic.sum();
    Matrix h(phi_.size(), phi_.size());
    for (Index row = 0; row < h.rows(); ++row)
      for (Index column = 0; column <= row; ++column)
        h(row, column) = h(column, row) = total * head(column) * tail(row);
    return h;
  }

  void advance() {
    const Real target = 0.15L * gap();
    Vector head, tail;
    weigh(head, tail);
    Matrix h = hessian(head, tail);
    h.diagonal() +=
        upper_force_.cwiseQuotient(upper_room_) + lower_force_.cwiseQuotient(lower_room_);
    const Vector pull =
        -gradient(head, tail) - target * (upper_room_.cwiseInverse() - lower_room_.cwiseInverse());
    const Eigen::LLT<Matrix> factor(h);
    Vector step = factor.solve(pull);
    if (problem_.loop) {
      const Vector round = factor.solve(Vector::Ones(step.size()));
      step -= round * (step.sum() / round.sum());
    }
    move(step, target);
  }

  void move(const Vector& step, Real target) {
    const Vector upper =
        (target + upper_force_.array() * step.array()) / upper_room_.array() - upper_force_.array();
    const Vector lower =
        (target - lower_force_.array() * step.array()) / lower_room_.array() - lower_force_.array();
    const Real length = std::min({reach(upper_room_, -step), reach(lower_room_, step),
                                  reach(upper_force_, upper), reach(lower_force_, lower)});
    d_ += length * step;
    upper_room_ -= length * step;
    lower_room_ += length * step;
    upper_force_ += length * upper;
    lower_force_ += length * lower;
  }

  // The longest step, at most 1, that leaves a hundredth of each positive value.
  static Real reach(const Vector& value, const Vector& change) {
    Real length = 1;
    for (Index i = 0; i < value.size(); ++i)
      if (change(i) < 0) length = std::min(length, -0.99L * value(i) / change(i));
    return length;
  }

  Sides sides() const {
    Sides found(static_cast<std::size_t>(problem_.phi.size()), 0);
    const Real scale = problem_.elastic.sum();
    for (Index j = 0; j < phi_.size(); ++j) {
      const auto k = static_cast<std::size_t>(contact(j));
      if (upper_force_(j) / scale > upper_room_(j) / phi_(j)) found[k] = 1;
      if (lower_force_(j) / scale > lower_room_(j) / phi_(j)) found[k] = -1;
    }
    return found;
  }

  const Problem& problem_;
  std::vector<Index> free_;  // the contacts with friction
  Vector phi_, d_;
  Vector upper_room_, lower_room_;    // phi - d, phi + d
  Vector upper_force_, lower_force_;  // their multipliers
};

// ---- the limit in closed form, and its optimality conditions ----

// Contacts at a bound tie segments into groups. No contact between groups carries a force, so
// each group balances by itself: sum L_i T_i = sum E_i.
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

// ---- all tendons together ----

void check_slips_follow(const Problem& problem, const Vector& u) {
  for (Index k = 0; k < problem.phi.size(); ++k) {
    const Real d = u(k) - u((k + 1) % u.size());
    const Real sign = problem.slip(k) > 0 ? -1 : problem.slip(k) < 0 ? 1 : 0;
    const Real off = sign == 0 ? std::max(Real(0), std::abs(d) - problem.phi(k))
                               : std::abs(d - sign * problem.phi(k));
    if (!(off < 1e-11L)) throw std::logic_error("reference model: a contact leaves its cone");
  }
}

Vector tensions(const Problem& problem) {
  const Vector u = Limit(problem, InteriorPoint(problem).solve()).solve();
  check_slips_follow(problem, u);
  return u.array().exp();
}

void append_contacts(const Tendon& tendon, const Problem& problem, bool moves,
                     std::vector<ReferenceContact>& contacts) {
  const std::size_t first = contacts.size();
  contacts.resize(first + tendon.kinds.size());
  for (std::size_t k = 0; k < tendon.kinds.size(); ++k) {
    const auto at = static_cast<Index>(k);
    contacts[first + k] = {tendon.segments[k].name,
                           tendon.segments[(k + 1) % tendon.segments.size()].name, tendon.kinds[k],
                           static_cast<double>(problem.phi(at)),
                           moves ? static_cast<double>(problem.slip(at)) : 0.0};
  }
}

void append_closing(const Tendon& tendon, const Problem& problem, bool moves,
                    std::map<int, double>& closing) {
  for (const int finger : tendon.fingers) {
    const auto found = problem.closing.find(finger);
    closing[finger] = moves && found != problem.closing.end() ? found->second : 0.0;
  }
}

}  // namespace

ReferenceResult reference_tensions(const std::string& word, const std::set<int>& held,
                                   ReferenceDirection direction,
                                   const ReferenceHardware& hardware) {
  const std::vector<Tendon> tendons = Reader().read(word);
  std::vector<Problem> problems;
  problems.reserve(tendons.size());
  for (const auto& tendon : tendons) problems.push_back(pose(tendon, held, direction, hardware));

  ReferenceResult result{};
  result.jams = std::any_of(problems.begin(), problems.end(),
                            [](const Problem& problem) { return problem.jams; });
  Real motor = 0;
  std::map<std::string, Real> tension;
  for (std::size_t t = 0; t < tendons.size(); ++t) {
    const auto& segments = tendons[t].segments;
    const bool carries = problems[t].jams == result.jams;
    const Vector absolute =
        carries ? tensions(problems[t]) : Vector::Zero(problems[t].length.size());
    for (std::size_t i = 0; i < segments.size(); ++i) {
      const Real value = absolute(static_cast<Index>(i));
      tension[segments[i].name] = value;
      if (segments[i].place == Place::motor_side) motor += value;
    }
    append_contacts(tendons[t], problems[t], !result.jams, result.contacts);
    append_closing(tendons[t], problems[t], !result.jams, result.closing);
  }
  for (const auto& [name, value] : tension)
    result.tension[name] = static_cast<double>(value / motor);
  return result;
}

}  // namespace reeve::testing
