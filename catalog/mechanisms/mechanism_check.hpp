// Recomputes the published numbers of the catalogue's mechanisms (mechanism.hpp) with the general
// solver, each with the rig and in the grasp that it was published for:
//
//   printed digits   agree if the computed number rounds to them, or is within their tolerance
//   closed forms     agree to 1e-9, relative
//
// A number from which a coefficient of its own rig was inferred has to agree, and proves nothing.
// What differs is explained if the listed expression gives it, likewise; open if it is listed as
// such, with the size. What is listed as explained or open and agrees is an error of the catalogue:
// it differs.
#pragma once

#include "catalog/check.hpp"
#include "catalog/mechanisms/mechanism.hpp"

namespace reeve::catalog {

CheckReport check_mechanism(const Mechanism& mechanism);

}  // namespace reeve::catalog
