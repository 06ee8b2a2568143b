// Evidence of a diagnosis that its text and its page both show.
#pragma once

#include <string>

#include "reports/diagnosis/diagnosis_report.hpp"
#include "reports/document/document.hpp"

namespace reeve::reports {

// "sheath, bearing, sheath"
std::string contacts_text(const std::vector<ContactKind>& contacts);

// How far the tension distribution is off, by routing. No rows where no reading has all strands.
Table share_error_table(const DiagnosisReport& report);

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

}  // namespace reeve::reports
