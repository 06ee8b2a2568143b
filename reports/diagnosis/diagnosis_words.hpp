// Phrases of a diagnosis that both the answer and its evidence use.
#pragma once

#include <cstddef>
#include <string>

#include "reports/diagnosis/diagnosis_report.hpp"

namespace reeve::reports {

// "TR3"; "" of what the catalogue does not have.
std::string catalogue_name(const DiagnosisReport& report, const std::string& word);

// A routing of the data by its catalogue name, or by its word.
std::string routing_name(const DiagnosisReport& report, std::size_t routing);

// "sensor_gain[T3] + wear", of causes that are there together.
std::string joined_causes(const std::vector<std::string>& names);

// To as many places as the interval is known.
std::string estimate(const EstimatedParameter& parameter, double value);

// "0.087 to 0.093"
std::string interval_text(const EstimatedParameter& parameter);
// "0.05 to 0.2", or what stands for none.
std::string literature_range(const EstimatedParameter& parameter, const char* none);

// "tube_friction, mu = 0.090 (0.087 to 0.093; nominal 0.180, literature 0.05 to 0.2)"; of
// a law "phi' = phi (1 + 0.0083 (humidity_pct - 50)), 95 % interval of a 0.0079 to 0.0087".
std::string cause_text(const NamedCause& cause);

// Meaning of a cause of the library, or of a law; and the unit of its i-th parameter.
std::string cause_meaning(const NamedCause& cause);
std::string parameter_unit(const NamedCause& cause, std::size_t i);

// A clause with subject and verb, and what is known of its sizes: "the tubes' friction is another
// one: tube_friction, mu = …", "sheath friction grows with humidity_pct: phi' = …".
std::string cause_sentence(const NamedCause& cause);

// "tube_friction, mu = 0.090 (0.087 to 0.093)"
std::string size_with_interval(const NamedCause& cause);

// True if readings of this size would hardly show it.
bool is_negligible(const DiagnosisReport& report, double part_N);

// "3.1 N of 3.1 N": what a part of the residuals is of those of the nominal model; with ",
// negligible" where it is.
std::string part_of_residuals(const DiagnosisReport& report, double part_N);
// The part that the strongest structure explains beyond chance, N.
double structure_N(const DiagnosisReport& report, const StructureFinding& finding);

// "exponent of tube of finger 2, by humidity_pct (45 nats)"
std::string lead_text(const Lead& lead);
// "Strongest leads: …"; empty without leads.
std::string leads_sentence(const DiagnosisReport& report);

// "on 2 held-out runs fall by 72 % (66 % to 77 %): from 0.41 N to 0.11 N"
std::string gain_text(const HeldOut& held_out, std::size_t runs);

// "TR3 (F-1-P-2-F) with finger 1 held, pulled with 20 N at the motor"
std::string measurement_text(const PlannedMeasurement& planned, const DiagnosisReport& report);

// Names the pattern that residuals follow. If there are no grasps to choose from, as on a bench,
// "grasp" becomes the direction.
std::string pattern_text(const DiagnosisReport& report, const std::string& about);

// Structure that chance gives less often than alpha says, and too often for the test of what is
// left.
bool weak_structure_remains(const DiagnosisReport& report);

// "180 readings in 6 runs, each run forecast once by a model fitted without it"
std::string used_text(const DiagnosisReport& report);

std::string newton(double value);
std::string percent_text(double share);  // "72 %"
// "0.83 %", "2.1 %", "190 %"
std::string fine_percent_text(double share);
std::string p_text(double p_value, std::size_t replicates);    // "p = 0.4", "p < 0.0025"
std::string p_number(double p_value, std::size_t replicates);  // "0.4", "< 0.0025"

// A log-likelihood: below a hundred to a tenth, which is where it decides anything.
std::string gain_number(double gain);                // "0.7", "206"
std::string gain_interval(double low, double high);  // "0.7 to 206"
// A motor tension, a speed, a cycle or a temperature that is to be set.
std::string set_value(double value);

std::string capitalised(std::string text);

}  // namespace reeve::reports
