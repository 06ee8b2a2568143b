// The coefficients that are uncertain, as a box: mu of tubes, sheaths and bearings, angle of
// sheaths. A point of it holds for all parts of a kind at once (one spool of liner, one sort of
// bearing); a mu that the hardware file sets for a single finger or contact stays as it is. Bends
// of sheaths that it sets so turn in proportion with the others, since posture bends whatever was
// mounted. A block turns on a bearing: where it has a mu of its own, that varies with theirs, in
// proportion. The ranges of mu are widened to hold the nominal values, if need be; a
// measured mu (`known = true`) does not vary.
//
// The hardware of a model varies, and the effects act on what comes out: they were found on a rig
// and are taken as known. So a coefficient that an effect replaces (tube_friction) does not vary,
// and one that it adds to or scales does.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "causes/model.hpp"
#include "core/hardware.hpp"
#include "core/uncertainty_ranges.hpp"
#include "numerics/minimise.hpp"

namespace reeve::search {

using CoefficientBox = std::array<Interval, 4>;

CoefficientBox coefficient_box(const Hardware& nominal, const UncertaintyRanges& ranges);

// A point drawn uniformly: a function of seed and number alone.
std::vector<double> drawn_point(const CoefficientBox& box, std::uint64_t seed, std::uint64_t draw);

// Returns the draw of each contact by itself, beside what a kind has in common; nothing if contacts
// do not scatter.
std::optional<ContactDraw> contact_draw(const Hardware& hardware, std::uint64_t seed,
                                        std::uint64_t draw);

std::vector<double> point_of(const Hardware& hardware);
// `point` has one value for each interval of the box.
Hardware at_point(const Hardware& nominal, const std::vector<double>& point);
Model at_point(const Model& nominal, const std::vector<double>& point);

// Draw number `draw` of a model, what a kind has in common and what each contact has by itself: a
// function of seed and number alone. Its effects are the nominal ones.
Model draw_model(const Model& nominal, const UncertaintyRanges& ranges, std::uint64_t seed,
                 std::uint64_t draw);

}  // namespace reeve::search
