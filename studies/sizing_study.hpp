// Routings with the dimensions that suit a goal best, ranked by it before and after.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "catalog/catalogue.hpp"
#include "core/routing.hpp"
#include "numerics/floors.hpp"
#include "sizing/size.hpp"
#include "sizing/tolerance.hpp"
#include "studies/shown_routing.hpp"
#include "studies/study_supervision.hpp"

namespace reeve::studies {

// The best designs of an exploration, from the folder that it wrote.
// The first `count` of designs.csv, which are in the order of their ranks; fewer, if it has no
// more. Throws InputError with file, line and column.
std::vector<Routing> explored_designs(const std::filesystem::path& folder, std::size_t count);

struct SizedRouting {
  SizedDesign design;
  std::string word;
  std::string name;  // "" if it has none
  // By the goal, then by fewer parts, then by word; from 1.
  std::size_t rank_before = 0;
  std::size_t rank_after = 0;
};

// The details of the best design are for a page: the hand that it makes, before and sized, and the
// goal along each variable. They are shown in the grasps that are asked.
struct SizingDetails {
  ShownRouting before;
  ShownRouting sized;
  std::vector<GoalProfile> profiles;  // parallel to the variables
};

struct SizingReport {
  SizingOptions options;
  std::vector<SizedRouting> designs;  // best after sizing first
  bool partial = false;
  std::uint64_t unconverged = 0;  // tension solves
  std::vector<std::string> notes{};
  std::optional<SizingDetails> details{};
};

// True if the best design meets the target, or if the goal is of another kind.
bool best_meets_target(const SizingReport& report);

// Returns the report before the search: the designs in the order given, with the dimensions as they
// are; partial.
SizingReport planned_sizing(const std::vector<Routing>& routings, const SizingOptions& options,
                            const Catalogue& catalogue);

SizingReport sizing_study(const std::vector<Routing>& routings, const SizingOptions& options,
                          const Catalogue& catalogue, const StudySupervision& supervision = {});

SizingDetails sizing_details(const SizingReport& report, const Catalogue& catalogue);

}  // namespace reeve::studies
