// The words that a user of the library writes most: reeve::parse_routing, reeve::tensions. All
// others stand in the namespace of their folder (numerics/floors.hpp).
#pragma once

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

namespace reeve {

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
using core::parse_routing;
using core::Performance;
using core::performance;
using core::Routing;
using core::tensions;
using core::TensionState;
using core::to_word;
using core::version;

}  // namespace reeve
