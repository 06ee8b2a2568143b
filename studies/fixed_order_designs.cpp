#include "studies/fixed_order_designs.hpp"

#include <algorithm>
#include <string>

#include "core/canonical.hpp"
#include "core/notation.hpp"

namespace reeve::studies {

std::vector<Routing> fixed_order_designs(int fingers) {
  std::vector<Routing> designs;
  for (unsigned joins = 0; joins < 1U << (fingers - 1); ++joins) {
    std::string walk = "1";
    for (int finger = 2; finger <= fingers; ++finger) {
      walk += ((joins >> (finger - 2)) & 1U) != 0 ? "-P-" : "-T-";
      walk += std::to_string(finger);
    }
    for (const std::string& word :
         {"M-" + walk + "-M", "M-" + walk + "-F", "F-" + walk + "-F", walk + "-P-1"}) {
      const Routing routing = canonical(parse_routing(word), FingerIdentity::distinct);
      if (!is_actuated(routing)) continue;
      if (std::find(designs.begin(), designs.end(), routing) == designs.end()) {
        designs.push_back(routing);
      }
    }
  }
  return designs;
}

}  // namespace reeve::studies
