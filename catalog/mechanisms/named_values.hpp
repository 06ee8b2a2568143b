// Names that an expression about a mechanism can use (mechanism.hpp).
#pragma once

#include "catalog/mechanisms/mechanism.hpp"
#include "core/network.hpp"
#include "core/tension/tension.hpp"

namespace reeve::catalog {

// Throws InputError if what the rig defines has a name that is taken.
NamedValues named_values(const MechanismRig& rig, const Network& network, const TensionState& state,
                         Direction direction);

// Returns the values solved with this rig, in the number's grasp and direction.
NamedValues solved_values(const PublishedNumber& number, const MechanismRig& rig);

}  // namespace reeve::catalog
