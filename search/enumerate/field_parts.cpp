#include "search/enumerate/field_parts.hpp"

#include <algorithm>

namespace reeve::search {
namespace {

std::uint64_t routings_with(GeneratorOptions generator, const PartSet& parts) {
  generator.parts = parts;
  return RoutingGenerator(generator).total();
}

// This many blocks let a tendon pull each finger by a block's side of its own, or in series by a
// block of its own.
int useful_blocks(const GeneratorOptions& generator) {
  return std::min(generator.fingers - (generator.parts.series ? 0 : 1), max_generated_blocks);
}

PartSet with_next_part(PartSet parts) {
  if (parts.anchored) ++parts.blocks;
  parts.anchored = true;
  return parts;
}

}  // namespace

FieldParts field_parts(const FieldRequest& request) {
  FieldParts field{request.generator.parts, std::nullopt};
  if (request.blocks) field.parts.blocks = *request.blocks;
  const int to_blocks = request.blocks.value_or(useful_blocks(request.generator));
  const std::uint64_t limit = most_field_routings(request.generator);
  std::uint64_t routings = routings_with(request.generator, field.parts);
  while (!field.parts.anchored || field.parts.blocks < to_blocks) {
    const PartSet next = with_next_part(field.parts);
    // A number above the limit already may be too many to count with another part.
    if (routings <= limit) routings = routings_with(request.generator, next);
    if (routings > limit) {
      field.left_out = {!field.parts.anchored, field.parts.blocks + 1, to_blocks, routings, limit};
      break;
    }
    field.parts = next;
  }
  return field;
}

}  // namespace reeve::search
