// Rigs that do what the library of causes has no name for, and rigs that do nothing of the kind,
// as benches are: their readings come from the tests' own solver and from laws written here, and
// share no code with the grammar of terms that is to find them.
//
//   law        one of 24 laws of a column or of the load, at one site, among six idle columns
//   idle       the same columns, and no law
//   bench      weights that hang on a tendon, read exactly, and a motor that scatters: a friction
//              exponent and a constant loss, with a run for each weight or for each repetition
//   apart      one run with rougher sheaths, one contact of one routing, or one sensor from some
//              run on
//   outliers   nothing but 2 % of readings that are wrong by factors of 1.3 to 3
//   imported   means of a logger's samples with their standard deviations: one gain, or nothing
//
// A third of the rigs scatters by 3 % from mounting to mounting, but none of bench and imported.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "diagnosis/diagnose.hpp"

namespace reeve::bench {

const std::vector<std::string>& foreign_parts();

// Diagnoses `sets` rigs of a part, and what the diagnosis forecasts of fresh runs. Markdown: rates,
// and with `list` a line for each rig that was missed.
std::string foreign_report(const std::string& part, std::size_t sets, std::uint64_t seed,
                           const DiagnoseOptions& options, bool list,
                           const std::filesystem::path& save);

}  // namespace reeve::bench
