#include "tests/support/reference_model.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <vector>

#include "tests/support/reference_limit.hpp"
#include "tests/support/reference_problem.hpp"
#include "tests/support/reference_shared.hpp"
#include "tests/support/reference_tree_solve.hpp"
#include "tests/support/reference_walk.hpp"

namespace reeve::testing {
namespace reference {
namespace {

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
  if (problem.elastic.isZero(0)) return problem.elastic;
  const Vector u = limit(problem, contacts_at_a_bound(problem));
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

ReferenceResult solve_one_by_one(const std::vector<Tendon>& tendons, const std::set<int>& held,
                                 ReferenceDirection direction, const ReferenceHardware& hardware) {
  ReferenceResult result{};
  std::vector<Problem> problems;
  problems.reserve(tendons.size());
  if (share_fingers(tendons)) {
    const SharedMotion motion = shared_motion(tendons, held, hardware);
    result.jams = result.opposed = !motion.possible;
    if (result.opposed) return result;
    for (std::size_t t = 0; t < tendons.size(); ++t)
      problems.push_back(
          pose_shared(tendons[t], motion.closing, motion.slack[t], direction, hardware));
  } else {
    for (const auto& tendon : tendons) problems.push_back(pose(tendon, held, direction, hardware));
  }
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
      if (segments[i].place == Place::motor_side) motor += spool(segments[i], hardware) * value;
    }
    append_contacts(tendons[t], problems[t], !result.jams, result.contacts);
    append_closing(tendons[t], problems[t], !result.jams, result.closing);
  }
  for (const auto& [name, value] : tension)
    result.tension[name] = static_cast<double>(value / motor);
  return result;
}

}  // namespace
}  // namespace reference

ReferenceResult reference_tensions(const std::string& word, const std::set<int>& held,
                                   ReferenceDirection direction,
                                   const ReferenceHardware& hardware) {
  const std::vector<reference::Tendon> tendons = reference::read_tendons(word);
  const bool blocks = std::any_of(tendons.begin(), tendons.end(), [](const auto& tendon) {
    return !tendon.passes.empty() || !tendon.ends.empty();
  });
  return blocks ? reference::solve_trees(tendons, held, direction, hardware)
                : reference::solve_one_by_one(tendons, held, direction, hardware);
}

}  // namespace reeve::testing
