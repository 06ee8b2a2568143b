// The tables of a hardware file that are about a hand: [hand], [motor], and what [finger.N] says of
// its joints and its force.
#pragma once

#include <string>

#include "catalog/toml_node.hpp"
#include "core/hardware.hpp"

namespace reeve::catalog {

// Reads [finger.N], which has other keys besides, or [hand].
FingerParts read_finger_parts(const TomlNode& table);

// Reads [hand] and [motor]. Their keys require a hand with joints; this is checked last.
void read_hand(const TomlNode& table, Hardware& hardware);
void read_motor(const TomlNode& table, Hardware& hardware);
void require_joints(const TomlNode& file, const Hardware& hardware);

// The keys of a finger's parts; both tables, none of which is written if it says nothing.
std::string finger_parts_toml(const FingerParts& parts);
std::string hand_toml(const Hardware& hardware);

}  // namespace reeve::catalog
