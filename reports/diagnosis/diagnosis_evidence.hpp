// Evidence of a diagnosis that its text, its JSON and its page show: tension distributions and
// losses, differences between the named groups of rows, scatter of readings and mountings, and the
// estimates of the free coefficients.
#pragma once

#include <string>
#include <vector>

#include "reports/diagnosis/diagnosis_report.hpp"
#include "reports/document/document.hpp"
#include "reports/output/json.hpp"

namespace reeve::reports {

// "sheath, bearing, sheath"
std::string contacts_text(const std::vector<ContactKind>& contacts);

// How far the tension distribution is off, by routing. No rows where no reading has all strands.
Table share_error_table(const DiagnosisReport& report);

// Adds a row for each cause by which held-out runs are forecast better, and one for all together.
void add_gains(const DiagnosisResult& result, Table& gains);

// The strongest patterns that the residuals follow, `most` at most.
Table structure_table(const DiagnosisReport& report, std::size_t most);

// Losses from sensor to sensor, as the remaining factor. It has no rows if no two neighbouring
// segments were measured.
Table loss_table(const DiagnosisReport& report);

// Sentences on the losses that stand apart in that table, on how the parameters depend on single
// runs, and on publications that draw other losses than their equations have. Each list may be
// empty.
std::vector<std::string> loss_sentences(const DiagnosisReport& report);
std::vector<std::string> without_apart_sentences(const DiagnosisReport& report);
std::vector<std::string> influence_sentences(const DiagnosisReport& report);
std::vector<std::string> published_sentences(const DiagnosisReport& report);

// "By group, each fitted by itself, sheath_friction differs: mu = 0.180 (0.170 to 0.190) in A,
// 0.120 (0.110 to 0.130) in B; B stands out (p < 0.001)"; none where no parameter differs.
std::vector<std::string> group_sentences(const DiagnosisReport& report);
// Each coefficient and cause, group by group; no rows without groups.
Table group_table(const DiagnosisReport& report);
// States that each group's readings scatter differently; empty if they do not.
std::string group_scatter_sentence(const DiagnosisReport& report);

Json by_group_json(const DiagnosisReport& report);
Json noise_of_groups_json(const DiagnosisReport& report);

std::vector<std::string> scatter_sentences(const DiagnosisResult& result);
// Says that residuals of a row are correlated; empty if they are not.
std::string row_sentence(const DiagnosisResult& result);
// Readings scatter so much that hardly anything would show.
bool drowns_in_noise(const DiagnosisResult& result);
// Warns that the noise, or the mounting-to-mounting scatter, is implausibly great; empty if neither
// is.
std::string beyond_belief_sentence(const DiagnosisResult& result);
Json row_scatter_json(const DiagnosisResult& result);
Json mountings_json(const DiagnosisResult& result);

// Why what looked likely is not named; none if nothing was dropped.
std::vector<std::string> not_named_sentences(const DiagnosisResult& result);

// "agrees with the nominal value (0.180)"; of one whose interval leaves the hardware's value out,
// but which is no named cause, that.
std::string beside_hardware(const CalibratedCoefficient& coefficient);
// "tube_friction: mu = 0.176 (0.165 to 0.187), agrees with the nominal value (0.180)"
std::vector<std::string> coefficient_sentences(const DiagnosisResult& result);
Json coefficients_json(const DiagnosisResult& result);

}  // namespace reeve::reports
