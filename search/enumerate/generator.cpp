#include "search/enumerate/generator.hpp"

#include "search/enumerate/checked.hpp"

namespace reeve::search {

RoutingGenerator::RoutingGenerator(const GeneratorOptions& options)
    : tendons_(options), total_(tendons_.total()) {
  if (options.parts.blocks == 0) return;
  trees_.emplace(options);
  total_ = plus(total_, trees_->total());
}

void RoutingGenerator::seek(std::uint64_t index) {
  tendons_.seek(index);
  if (!trees_) return;
  const std::uint64_t before = tendons_.total();
  trees_->seek(index < before ? 0 : index - before);
}

ShardRange shard_range(std::uint64_t total, std::uint64_t i, std::uint64_t n) {
  const auto cut = [&](std::uint64_t part) {
    return static_cast<std::uint64_t>(Wide{total} * part / n);
  };
  return {cut(i - 1), cut(i)};
}

}  // namespace reeve::search
