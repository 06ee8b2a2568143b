// A model of a rig: its hardware, and the effects of causes by which it differs from the plain
// friction model. Without effects it is that model.
#pragma once

#include <span>
#include <vector>

#include "causes/cause.hpp"
#include "core/hardware.hpp"
#include "core/mechanics.hpp"
#include "core/tension/seizure.hpp"
#include "core/tension/tension.hpp"

namespace reeve::causes {

struct Model {
  Hardware hardware;
  std::vector<Effect> effects{};  // in the order of the library, then laws by their targets
  // Under which a design is judged, where no reading says otherwise.
  Conditions conditions{};
};

// One row for each condition.
struct ConditionRow {
  const char* name;
  const char* unit;
  double Conditions::*value;
  Range range;  // range in a stored model
};
std::span<const ConditionRow> condition_table();

// Adds an effect at its place in that order.
void add_effect(Model& model, Effect effect);

// The hardware with all effects on it.
Hardware effective_hardware(const Model& model);
// The same. Throws InputError of a fault of the model's own hardware, and OutOfRange if the effects
// make of it what there cannot be.
Hardware possible_hardware(const Model& model);
Hardware effective_hardware(Hardware hardware, const std::vector<Effect>& effects);

// True if an effect has this reach.
bool reaches(const Model& model, Reach reach);
// True if some contacts have other exponents than hardware and a routing's network give them.
bool changes_exponents(const Model& model);
// True if an effect on contacts is about one routing.
bool names_routings(const Model& model);

// True if neither hardware nor laws tell fingers 1 … `fingers` apart.
bool treats_fingers_alike(const Model& model, int fingers);

Grasp actual_grasp(const Model& model, const std::string& word, Grasp recorded);
std::vector<std::size_t> seized_contacts(const Model& model, const std::string& word,
                                         const Network& network);
// The effects that a design has, whoever measures it. Those on readings and records are the rig's:
// also pretension, which the motor does no work for and which therefore is no merit or fault of a
// routing, and what is lost between the motor and the tendons, which is lost to every routing
// alike; and those that a run or a group has by itself.
bool belongs_to_designs(const Effect& effect);

// The conditions as they are at the tendons of a rig whose motor is recorded to pull as they say;
// its tension is not below 0.
Conditions at_tendon(const Model& model, Direction direction, const Conditions& recorded);

// Makes of the tensions of a routing's sensors what they read.
void read(const Model& model, Direction direction, const Conditions& conditions,
          std::span<Sensor> sensors);
// Returns the first reading in a file of a sensor at this segment that has no others beside it.
double reading(const Model& model, const Segment& segment, double tension_N);
// True if readings are linear in the tensions, up to an offset.
bool reads_linearly(const Model& model);

}  // namespace reeve::causes
