#include "search/routing_source.hpp"

#include <utility>

namespace reeve::search {
namespace {

// True if the generator passes over what is beyond limits for these options.
bool may_be_limited(const GeneratorOptions& generator) {
  return generator.identity == FingerIdentity::identical && generator.parts.motors == 1 &&
         generator.parts.beside.empty();
}

// Without blocks, to pass over tendons that hang on no motor is cheaper than to make them; with
// blocks it is not.
bool is_limited(const GeneratorOptions& generator, bool prunes) {
  return prunes || (may_be_limited(generator) && generator.parts.blocks == 0);
}

PartClasses classes_of(const ExploreOptions& options, bool prunes) {
  if (!is_limited(options.generator, prunes)) return {};
  return {prunes ? options.constraints : std::vector<Constraint>{}, options.generator};
}

}  // namespace

std::size_t pruning_constraints(const ExploreOptions& options) {
  if (!may_be_limited(options.generator)) return 0;
  return decided_by_parts(options.constraints, options.generator);
}

RoutingSource::RoutingSource(const ExploreOptions& options, bool prunes)
    : prunes_(prunes),
      is_limited_(is_limited(options.generator, prunes)),
      generator_(options.generator, classes_of(options, prunes)) {}

void RoutingSource::stop_with(const std::atomic<bool>* stop) {
  check_ = StopCheck(stop);
  generator_.stop_with(check_);
}

void RoutingSource::seek(std::uint64_t begin, std::uint64_t end) {
  end_ = end;
  generator_.seek(begin);
}

bool RoutingSource::next(Routing& routing, std::uint64_t& place) {
  while (generator_.next(routing, place) && place < end_) {
    if (is_limited_ || is_actuated(routing)) return true;
    check_.step();
  }
  return false;
}

bool RoutingSource::leave_out_unwanted(const Hardware& hardware, IsWanted is_wanted) {
  leaves_out_unwanted_ =
      is_limited_ && generator_.leave_out_unwanted(hardware, std::move(is_wanted));
  return leaves_out_unwanted_;
}

std::optional<RoutingSource::LeftOutPlace> RoutingSource::place_left_out(const Routing& routing) {
  if (!prunes_) return std::nullopt;
  const std::size_t verdict = generator_.verdict(routing);
  if (verdict < failing(0)) return std::nullopt;
  const auto place = generator_.place_of(routing);
  return place ? std::optional(LeftOutPlace{*place, verdict - failing(0)}) : std::nullopt;
}

}  // namespace reeve::search
