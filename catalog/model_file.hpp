// A model file (TOML): a hardware file that also says under which conditions designs are judged and
// by which effects the rig differs from the plain model.
//
//   [conditions]            each with the reference value as its default
//   motor_tension_N = 10
//   speed_mm_s = 10
//   cycle = 0
//   temperature_C = 20
//
//   [[effect]]              as often as there are effects
//   cause = "sensor_gain"   a name of causes/library.hpp
//   channel = "T3"          the subject, if the cause has one:
//                             channel | finger | routing, recorded, actual | routing, contact
//   gain = 1.08             every parameter of the cause
//
//   [[law]]                 as often as there are laws: law_tables.hpp
//
// [conditions] takes the columns that laws ask for, too; without its column a law is at its middle.
// Routings are words, or names of the catalogue that is read with it. A model without effects is
// the plain friction model.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "catalog/catalogue.hpp"
#include "catalog/hardware_file.hpp"
#include "causes/model.hpp"
#include "core/uncertainty_ranges.hpp"

namespace reeve::catalog {

struct ModelFile {
  Model model;
  UncertaintyRanges uncertainty;
  VaryTable vary{};
};

// Throws InputError with file, line, column, key, value and what was expected.
ModelFile read_model_file(const std::filesystem::path& path, const Catalogue& catalogue = {});

// The [[law]] tables of a file that has nothing else, at least one: laws to look for in readings.
// Throws InputError as above.
std::vector<Effect> read_terms_file(const std::filesystem::path& path, const Catalogue& catalogue);

// Reads back as the same model, bit by bit. The comment lines stand at the top.
std::string model_toml(const Model& model, const std::vector<std::string>& comment_lines,
                       const UncertaintyRanges& uncertainty = {});

}  // namespace reeve::catalog
