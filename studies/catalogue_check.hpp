// Everything published that the catalogue's files hold, computed again: its routings
// (catalog/number_check.hpp) and publications, which are the family "paper", and its other
// families.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "catalog/catalogue.hpp"
#include "catalog/number_check.hpp"
#include "catalog/publication.hpp"
#include "core/routing.hpp"
#include "readings/measured_data.hpp"

namespace reeve::studies {

// Derives again every number that a publication derives from its readings and from its model:
//
//   sums of a routing's strands      agree to what the readings can be read to
//   indicators and their means       of the strands as read, and of motor-side tensions that follow
//                                    from them by the sheaths' ratio (catalog/publication.hpp)
//   errors of model lines            mean over the routings of √ Σ (share − share)², of the lines
//                                    as printed and of what the equations give
//   coefficient of the sheaths       beside the ratio that the indicators need
//   designs of n fingers             counted by writing all of them down (fixed_order_designs())
//
// Tolerances are propagated: every reading may be off by as much as it can be read to, every
// printed number by half a unit. Adaptability, balance and reliability are concave in the tensions,
// so that a mean over trials is at most what the mean tensions give (J. Jensen, 1906); it may be
// less by the scatter over the trials, 1.33 standard deviations at most for a normal one. As in
// catalog/number_check.hpp a number is explained only by a listed fault whose arithmetic holds.
// Throws InputError if the readings or the catalogue lack a routing of the publication.
std::vector<CheckItem> check_publication(const Catalogue& catalogue, const Publication& publication,
                                         const MeasuredData& readings);

// The designs of one tendon that passes fingers 1, 2, …, n in this order: joins T or P between
// them, and the outer strands closed in one of four ways: both on the motor, one on the motor and
// one fixed (the motor at finger 1), both fixed, or both round one movable pulley.
inline constexpr int closings_in_fixed_order = 4;

// All that a motor pulls, each once.
std::vector<Routing> fixed_order_designs(int fingers);

// One family after the other, or one alone. `files` are those that the catalogue was read from.
// Throws InputError.
CheckReport check_all(const Catalogue& catalogue, const CatalogueFiles& files,
                      const std::optional<std::string>& family = std::nullopt);

}  // namespace reeve::studies
