// What a user of the installed library writes: TR7 with finger 1 held. Fails if it comes out wrong.
#include <reeve/core/reeve.hpp>

#include <cmath>
#include <iostream>

int main() {
  const reeve::Network network = reeve::expand(reeve::parse_routing("1-P-2-P-1"));
  const reeve::Mechanics parts = reeve::mechanics(network, reeve::Hardware{});
  const reeve::TensionState state = reeve::tensions(network, parts, reeve::hold({1}));
  const double uniformity = reeve::performance(network, state).uniformity;
  const double expected = std::exp(-0.001 * 3.14159265358979);  // Eq. 23 of the paper: e^{-phi_b}
  std::cout << reeve::version().number << ' ' << uniformity << '\n';
  return std::abs(uniformity - expected) < 1e-12 ? 0 : 1;
}
