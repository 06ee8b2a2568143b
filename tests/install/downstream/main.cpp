// What a user of the installed library writes: TR7 with finger 1 held, and the routings of two
// fingers. Fails if one of them comes out wrong.
#include <reeve/reeve.hpp>

#include <cmath>
#include <iostream>

int main() {
  const reeve::Routing routing = reeve::parse_routing("1-P-2-P-1");
  const reeve::TensionState state = reeve::tensions(routing, {}, reeve::hold({1}));
  const double uniformity = reeve::performance(reeve::expand(routing), state).uniformity;
  const double expected = std::exp(-0.001 * 3.14159265358979);  // Eq. 23 of the paper: e^{-phi_b}

  reeve::ExploreOptions options;
  options.generator.fingers = 2;
  const reeve::ExploreReport found = reeve::explore(options);  // 54 of 126 hang on the motor
  reeve::RankRequest request;
  for (const char* word : {"M-1-T-2-F", "1-P-2-P-1"}) {
    request.routings.push_back(reeve::parse_routing(word));
  }
  const reeve::RankReport ranked = reeve::rank(request);

  std::cout << reeve::version().number << ' ' << uniformity << '\n';
  const bool is_right = std::abs(uniformity - expected) < 1e-12 && found.top.size() == 54 &&
                        ranked.designs.front().ranked.design.word == "1-P-2-P-1";
  return is_right ? 0 : 1;
}
