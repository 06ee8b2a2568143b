#include "search/enumerate/tendon_generator.hpp"

#include <fmt/format.h>

#include "core/error.hpp"
#include "search/enumerate/checked.hpp"
#include "search/enumerate/counting.hpp"

namespace reeve::search {
namespace {

const GeneratorOptions& validated(const GeneratorOptions& options) {
  validate(options.parts);
  if (options.fingers < 1 || options.fingers > max_fingers) {
    throw InputError({.what = fmt::format("fingers {}", options.fingers),
                      .expected = fmt::format("a number from 1 to {}", max_fingers)});
  }
  return options;
}

std::vector<std::uint64_t> totals(const GeneratorOptions& options) {
  const TendonCounts tendons = tendon_counts(options.parts, options.fingers, options.identity);
  return options.one_tendon ? tendons : tendon_sets(tendons, options.fingers, options.identity);
}

std::uint64_t numberings(const Routing& shapes) {
  std::uint64_t symmetries_of_all = 1;
  std::uint64_t twins = 1;
  for (std::size_t t = 0; t < shapes.tendons.size(); ++t) {
    const Tendon& tendon = shapes.tendons[t];
    twins = t > 0 && same_shape(shapes.tendons[t - 1], tendon) ? twins + 1 : 1;
    symmetries_of_all =
        times(symmetries_of_all, times(twins, static_cast<std::uint64_t>(symmetries(tendon))));
  }
  return factorial(finger_count(shapes)) / symmetries_of_all;
}

}  // namespace

TendonGenerator::TendonGenerator(const GeneratorOptions& options, const PartClasses& classes)
    : is_distinct_(options.identity == FingerIdentity::distinct),
      totals_(totals(validated(options))),
      shapes_(classes, options.parts, options.fingers, options.one_tendon,
              classes.count() > 1 ? ListedShapes::default_longest : 0) {}

bool TendonGenerator::next(Routing& routing, std::uint64_t& index) {
  if (!is_distinct_) return shapes_.next(routing, index);
  if (!is_unread_ && !next_numbered()) return false;
  is_unread_ = false;
  index = next_index_++;
  routing = numbered_;
  return true;
}

bool TendonGenerator::next_numbered() {
  if (is_numbered_ && numbering_.next(numbered_)) return true;
  std::uint64_t of_shapes = 0;
  is_numbered_ = shapes_.next(numbered_, of_shapes);
  if (is_numbered_) numbering_.start(numbered_);
  return is_numbered_;
}

void TendonGenerator::seek_numbered(std::uint64_t index) {
  next_index_ = index;
  std::uint64_t of_shapes = 0;
  while (shapes_.next(numbered_, of_shapes)) {
    const std::uint64_t here = numberings(numbered_);
    if (index < here) break;
    index -= here;
  }
  numbering_.start(numbered_);
  for (; index > 0; --index) numbering_.next(numbered_);
  is_numbered_ = is_unread_ = true;
}

void TendonGenerator::seek(int fingers, PartClass beside, std::uint64_t index) {
  is_numbered_ = is_unread_ = false;
  const bool counts_numbers = is_distinct_ && index < total(fingers);
  shapes_.seek(fingers, beside, counts_numbers ? 0 : index);
  if (counts_numbers) seek_numbered(index);
}

}  // namespace reeve::search
