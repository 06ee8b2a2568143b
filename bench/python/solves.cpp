// The solves of tensions.py without Python: one core, the same routings and coefficients.
//
//     reeve_solves SAMPLES WORD…
//
// SAMPLES is a file of doubles. Prints a line for each routing with finger 1 held: its word, the
// processor's seconds for one solve with the paper's hardware, those for one in a loop over the
// samples as friction coefficient of tubes and sheaths, and the sum of all tensions of that loop.
#include <fmt/format.h>

#include <algorithm>
#include <ctime>
#include <fstream>
#include <limits>
#include <string>
#include <vector>

#include "core/mechanics.hpp"
#include "core/network.hpp"
#include "core/notation.hpp"
#include "core/tension/tension.hpp"

namespace reeve::bench {
namespace {

using namespace core;

constexpr int repeats = 5;
constexpr int single_solves = 20000;

std::vector<double> read_samples(const char* file) {
  std::ifstream stream(file, std::ios::binary);
  std::vector<double> samples;
  double sample = 0;
  while (stream.read(reinterpret_cast<char*>(&sample), sizeof sample)) samples.push_back(sample);
  return samples;
}

template <typename Work>
double least_seconds(Work work) {
  double least = std::numeric_limits<double>::infinity();
  for (int i = 0; i < repeats; ++i) {
    const std::clock_t begin = std::clock();
    work();
    least = std::min(least, static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC);
  }
  return least;
}

void measure(const std::string& word, const std::vector<double>& samples) {
  const Network network = expand(parse_routing(word));
  const Hardware hardware;
  const MechanicsBuilder plain(hardware);
  MechanicsBuilder varied(hardware);
  Mechanics mechanics;
  TensionSolver solver;
  TensionState state;
  std::vector<double> table(samples.size() * network.segments.size());
  const double single = least_seconds([&] {
    for (int i = 0; i < single_solves; ++i) {
      plain.apply(network, mechanics);
      solver.solve(network, mechanics, Grasp{0b1}, Direction::pull, state);
    }
  });
  const double looped = least_seconds([&] {
    auto row = table.begin();
    for (const double mu : samples) {
      varied.set_law(ContactKind::tube, {mu, hardware.tube.angle_rad});
      varied.set_law(ContactKind::sheath, {mu, hardware.sheath.angle_rad});
      varied.apply(network, mechanics);
      solver.solve(network, mechanics, Grasp{0b1}, Direction::pull, state);
      row = std::copy(state.tension.begin(), state.tension.end(), row);
    }
  });
  double sum = 0;
  for (const double tension : table) sum += tension;
  fmt::print("{} {} {} {}\n", word, single / single_solves,
             looped / static_cast<double>(samples.size()), sum);
}

}  // namespace
}  // namespace reeve::bench

int main(int argc, char** argv) {
  if (argc < 3) return 2;
  const std::vector<double> samples = reeve::bench::read_samples(argv[1]);
  for (int i = 2; i < argc; ++i) reeve::bench::measure(argv[i], samples);
}
