// Common parts of the benchmarks: routings by word, ready to be solved.
#pragma once

#include <algorithm>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "core/grasp.hpp"
#include "core/mechanics.hpp"
#include "core/network.hpp"
#include "core/notation.hpp"
#include "search/enumerate/generator.hpp"

namespace reeve::bench {

struct Prepared {
  Network network;
  Mechanics mechanics;
};

inline Prepared prepare(const std::string& word) {
  Network network = expand(parse_routing(word));
  Mechanics values = mechanics(network, Hardware{});
  return {std::move(network), std::move(values)};
}

// Full parts, identical fingers, any number of tendons: the largest search space for a hand.
inline GeneratorOptions full_search(int fingers) {
  GeneratorOptions options;
  options.fingers = fingers;
  return options;
}

// `count` actuated routings, taken evenly from all of them.
inline std::vector<Routing> sample_of_routings(int fingers, std::uint64_t count) {
  RoutingGenerator generator(full_search(fingers));
  const std::uint64_t step = std::max<std::uint64_t>(1, generator.total() / count);
  std::vector<Routing> sample;
  for (std::uint64_t index = 0; index < generator.total(); index += step) {
    generator.seek(index);
    Routing routing;
    while (generator.next(routing) && !is_actuated(routing)) {
    }
    if (is_actuated(routing)) sample.push_back(routing);
  }
  return sample;
}

}  // namespace reeve::bench
