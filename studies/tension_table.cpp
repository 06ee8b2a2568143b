#include "studies/tension_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <limits>
#include <mutex>
#include <optional>
#include <tuple>

#include "core/error.hpp"
#include "core/graph.hpp"
#include "core/mechanics.hpp"
#include "core/notation.hpp"
#include "core/tension/tension.hpp"
#include "numerics/parallel.hpp"

namespace reeve::studies {
namespace {

// A block of samples is some tenths of a millisecond: long beside what handing it out costs, short
// beside what somebody waits who stops it.
constexpr std::size_t grain = 256;

struct TableRouting {
  std::string word;
  Network network;
  std::vector<std::size_t> place;  // indices of its segments among the table's
};

std::vector<TableRouting> table_routings(const std::vector<Routing>& routings,
                                         const std::vector<Segment>& segments) {
  std::vector<TableRouting> result;
  for (const Routing& routing : routings) {
    TableRouting& one = result.emplace_back();
    one.word = to_word(routing);
    one.network = expand(routing);
    require_actuated(one.network, one.word);
    for (const Segment& segment : one.network.segments) {
      const auto at = std::ranges::find(segments, segment);
      one.place.push_back(static_cast<std::size_t>(at - segments.begin()));
    }
  }
  return result;
}

ContactLaw law_of(const Hardware& hardware, ContactKind kind) {
  switch (kind) {
    case ContactKind::bearing:
      return hardware.bearing;
    case ContactKind::sheath:
      return hardware.sheath;
    case ContactKind::block:
      return hardware.block.value_or(hardware.bearing);
    case ContactKind::tube:
    case ContactKind::bar:
      break;
  }
  return hardware.tube;
}

void set_law_of(Hardware& hardware, ContactKind kind, const ContactLaw& law) {
  if (kind == ContactKind::tube) hardware.tube = law;
  if (kind == ContactKind::bearing) hardware.bearing = law;
  if (kind == ContactKind::sheath) hardware.sheath = law;
  if (kind == ContactKind::block) hardware.block = law;
}

// Laws such as these the hardware's own check never refuses; it is asked about all others.
bool is_plain(const ContactLaw& law) {
  return law.mu >= 0 && law.mu <= 1 && law.angle_rad >= 0 && law.angle_rad <= 100 &&
         law.exponent() <= max_exponent;
}

// One for each worker; keeps its memory.
class SampleSolver {
 public:
  explicit SampleSolver(const TensionTableRequest& request)
      : request_(request), builder_(request.hardware), varied_(request.hardware) {
    const auto varies = [&](ContactKind kind) {
      return std::ranges::any_of(
          request.columns, [&](const CoefficientColumn& column) { return column.kind == kind; });
    };
    for (const ContactKind kind :
         {ContactKind::tube, ContactKind::bearing, ContactKind::sheath, ContactKind::block}) {
      if (varies(kind)) kinds_.push_back(kind);
    }
  }

  void prepare(const TableRouting& routing, std::size_t sample) {
    if (&routing == routing_ && (sample == sample_ || kinds_.empty())) return;
    for (const ContactKind kind : kinds_) set_law(kind, sample);
    builder_.apply(routing.network, mechanics_);
    builder_.require_in_range(routing.network, mechanics_);
    routing_ = &routing;
    sample_ = sample;
  }

  const TensionState& solve(Grasp grasp) {
    solver_.solve(routing_->network, mechanics_, grasp, request_.direction, state_);
    return require_in_range(state_, grasp);
  }

 private:
  void set_law(ContactKind kind, std::size_t sample) {
    ContactLaw law = law_of(request_.hardware, kind);
    for (const CoefficientColumn& column : request_.columns) {
      if (column.kind != kind) continue;
      (column.term == LawTerm::mu ? law.mu : law.angle_rad) = column.values[sample];
    }
    if (!is_plain(law)) require_valid(kind, law, sample);
    builder_.set_law(kind, law);
  }

  void require_valid(ContactKind kind, const ContactLaw& law, std::size_t sample) {
    set_law_of(varied_, kind, law);
    try {
      validate(varied_);
    } catch (const InputError& error) {
      for (const CoefficientColumn& column : request_.columns) {
        if (column.kind == kind) throw error.at(fmt::format("{}[{}]", column.name, sample));
      }
      throw;
    }
  }

  const TensionTableRequest& request_;
  std::vector<ContactKind> kinds_;  // kinds that vary; bearings before blocks
  MechanicsBuilder builder_;
  Hardware varied_;
  Mechanics mechanics_;
  TensionSolver solver_;
  TensionState state_;
  const TableRouting* routing_ = nullptr;
  std::size_t sample_ = 0;
};

std::tuple<int, int> order_of(const Segment& segment) {
  return {static_cast<int>(segment.kind), segment.number};
}

}  // namespace

std::vector<Segment> table_segments(const std::vector<Routing>& routings) {
  std::vector<Segment> segments;
  for (const Routing& routing : routings) {
    const Network network = expand(routing);
    segments.insert(segments.end(), network.segments.begin(), network.segments.end());
  }
  std::ranges::sort(segments, {}, order_of);
  segments.erase(std::unique(segments.begin(), segments.end()), segments.end());
  return segments;
}

std::size_t table_size(const TensionTableRequest& request) {
  return request.routings.size() * request.grasps.size() * request.samples *
         table_segments(request.routings).size();
}

bool fill_tension_table(const TensionTableRequest& request, std::span<double> table,
                        const StudySupervision& supervision) {
  const std::vector<Segment> segments = table_segments(request.routings);
  const std::vector<TableRouting> routings = table_routings(request.routings, segments);
  const std::size_t grasps = request.grasps.size();
  const std::size_t total = routings.size() * request.samples;
  const bool complete = std::ranges::all_of(
      routings, [&](const auto& routing) { return routing.place.size() == segments.size(); });
  if (!complete) {
    std::ranges::fill(table, std::numeric_limits<double>::quiet_NaN());
  }
  Workers workers(request.threads);
  std::vector<std::optional<SampleSolver>> solvers(workers.count());
  std::atomic<std::uint64_t> done{0};
  std::mutex reporting;
  workers.for_each_block(total, grain, [&](const IndexBlock& block) {
    if (supervision.stopped()) return;
    auto& solver = solvers[block.worker];
    if (!solver) solver.emplace(request);
    std::size_t r = block.begin / request.samples;
    std::size_t sample = block.begin % request.samples;
    for (std::size_t i = block.begin; i < block.end; ++i, ++sample) {
      if (sample == request.samples) {
        sample = 0;
        ++r;
      }
      solver->prepare(routings[r], sample);
      for (std::size_t g = 0; g < grasps; ++g) {
        const TensionState& state = solver->solve(request.grasps[g]);
        const std::size_t row = ((r * grasps + g) * request.samples + sample) * segments.size();
        for (std::size_t k = 0; k < routings[r].place.size(); ++k) {
          table[row + routings[r].place[k]] = state.tension[k];
        }
      }
    }
    done += block.end - block.begin;
    if (!supervision.report) return;
    const std::scoped_lock lock(reporting);
    supervision.report("solving", {done.load(), total});
  });
  return !supervision.stopped();
}

}  // namespace reeve::studies
