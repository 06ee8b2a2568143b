// A cause of the library as a row of a table. Its law stands in the comment above the row, with
// units, literature and source. A function that is null changes nothing.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "causes/cause.hpp"

namespace reeve::causes {

struct CauseRow {
  const char* name = "";
  Reach reach = Reach::hardware;
  const char* meaning = "";
  std::vector<Parameter> parameters{};
  SubjectKind subject_kind = SubjectKind::rig;

  // The data can show the cause if they have such contacts, and what it needs besides.
  bool (*contacts)(ContactKind) = nullptr;  // an exponent changes at these only
  bool Survey::*needs = nullptr;
  const char* follows = "";  // covariate over which it shows
  // Null: one subject, or one for each channel.
  std::vector<Subject> (*subjects)(const Survey&) = nullptr;
  bool (*is_also_named)(const Subject&, std::string_view name, const Survey&) = nullptr;

  // Its friction coefficient is the parameter of the cause, and nominal as the hardware says.
  ContactLaw Hardware::*law = nullptr;
  void (*change_hardware)(Hardware&, const Effect&) = nullptr;
  double (*exponent)(double phi, const ContactLoad&, const Conditions&,
                     const std::vector<double>& values) = nullptr;
  Grasp (*actual_grasp)(const std::string&, Grasp recorded, const Effect&) = nullptr;
  std::optional<std::size_t> (*seized_contact)(const std::string&, const Network&,
                                               const Effect&) = nullptr;
  double (*at_tendon)(double motor_tension_N, Direction, const Conditions&,
                      const std::vector<double>& values) = nullptr;
  // Reading of the subject's own channel.
  double (*reading)(double tension_N, const std::vector<double>& values) = nullptr;
  void (*read)(std::span<Sensor> sensors, const Conditions&, const Effect&) = nullptr;
  bool (*shows_between)(double least_N, double greatest_N, const Effect&) = nullptr;
  bool reads_linearly = true;
};

// The causes of the library, in three parts.
std::vector<CauseRow> friction_causes();  // contacts and sheaths
std::vector<CauseRow> rig_causes();       // grasp, seized contacts and motor
std::vector<CauseRow> sensor_causes();

}  // namespace reeve::causes
