// The door of the library: what the program's subcommands and the Python module do, as functions
// from values to values.
//
//   tensions   one routing in one grasp (core/tension/tension.hpp)
//   explore    every routing of a set of parts, ranked (search/explore.hpp)
//   rank       routings that somebody has in mind (studies/ranking_study.hpp)
//   size       the dimensions of a routing's parts that suit a goal best (sizing/size.hpp)
//   diagnose   measured tensions: what the model gets wrong, and why (studies/diagnosis_study.hpp)
//
// Lengths are in mm, angles in rad, tensions in N or as shares of the motor's. Bad input throws
// InputError, what has no answer OutOfRange. Everything else of the library stands in the namespace
// of its folder (numerics/floors.hpp).
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "catalog/catalogue.hpp"
#include "catalog/catalogue_files.hpp"
#include "core/error.hpp"
#include "core/grasp.hpp"
#include "core/hardware.hpp"
#include "core/mechanics.hpp"
#include "core/network.hpp"
#include "core/notation.hpp"
#include "core/performance.hpp"
#include "core/routing.hpp"
#include "core/tension/tension.hpp"
#include "core/version.hpp"
#include "readings/measured_data.hpp"
#include "search/explore.hpp"
#include "sizing/size.hpp"
#include "studies/diagnosis_study.hpp"
#include "studies/exploration_study.hpp"
#include "studies/ranking_study.hpp"
#include "studies/sizing_study.hpp"

namespace reeve {

using catalog::Catalogue;
using core::Direction;
using core::expand;
using core::Grasp;
using core::Hardware;
using core::hold;
using core::InputError;
using core::InputFault;
using core::Mechanics;
using core::mechanics;
using core::Network;
using core::OutOfRange;
using core::paper_grasps;
using core::parse_grasps;
using core::parse_routing;
using core::Performance;
using core::performance;
using core::Routing;
using core::single_grasps;
using core::tensions;
using core::TensionState;
using core::to_word;
using core::version;
using readings::MeasuredData;
using readings::ReadingOptions;
using search::ExploreOptions;
using sizing::SizingOptions;
using studies::DiagnosisReport;
using studies::DiagnosisRequest;
using studies::ExploreReport;
using studies::RankReport;
using studies::RankRequest;
using studies::SizingReport;

// Returns the routings that are known: those of the folder that REEVE_CATALOG names, or else those
// that the library was built with.
inline Catalogue catalogue() { return catalog::read_catalogue(catalog::CatalogueFiles::shipped()); }

// Returns the tensions of all segments at a motor tension of 1 N, in the order of
// expand(routing).segments.
inline TensionState tensions(const Routing& routing, const Hardware& hardware = {},
                             const Grasp& grasp = {}, Direction direction = Direction::pull) {
  const Network network = expand(routing);
  return tensions(network, mechanics(network, hardware), grasp, direction);
}

// Without grasps those in which each finger is held alone, and none.
inline ExploreReport explore(ExploreOptions options) {
  if (options.grasps.empty()) options.grasps = single_grasps(options.generator.fingers);
  return studies::exploration_study(options, std::nullopt, catalogue());
}

// Without grasps as explore(). The routings have as many fingers each.
inline RankReport rank(RankRequest request) {
  if (request.grasps.empty() && !request.routings.empty()) {
    request.grasps = single_grasps(core::finger_count(request.routings.front()));
  }
  return *studies::ranking_study(request, catalogue());  // nobody stops it
}

// Without grasps as explore(). The routings have as many fingers each.
inline SizingReport size(const std::vector<Routing>& routings, SizingOptions options) {
  if (options.grasps.empty() && !routings.empty()) {
    options.grasps = single_grasps(core::finger_count(routings.front()));
  }
  return studies::sizing_study(routings, options, catalogue());
}

// Returns the readings of a CSV file, in which routings are words or names of the catalogue.
inline MeasuredData read_readings(const std::filesystem::path& file,
                                  const ReadingOptions& options = {}) {
  const Catalogue known = catalogue();
  const auto routing = [&](const std::string& text) {
    const Routing* named = known.find_routing(text);
    return named != nullptr ? *named : parse_routing(text);
  };
  return readings::read_measured_data(file, routing, options);
}

// Runs to its end: `stage` and `stop` of the request are not asked.
inline DiagnosisReport diagnose(DiagnosisRequest request) {
  request.stage = {};
  request.stop = nullptr;
  return *studies::diagnosis_study(std::move(request), catalogue());
}

}  // namespace reeve
