// The tables of a diagnosis' page, as HTML; "" of those that have no row.
#pragma once

#include <string>

#include "pages/diagnosis/diagnosis_page.hpp"

namespace reeve::pages {

std::string sizes_table(const DiagnosisResult& result);
// What the free friction coefficients came to, whether or not they are causes.
std::string calibration_table(const DiagnosisResult& result);
std::string groups_table(const DiagnosisReport& report);
// Every model that was weighed, the named one marked in words and by its sign.
std::string weighed_table(const DiagnosisResult& result);
std::string gains_table(const DiagnosisResult& result);
std::string structure_table(const DiagnosisReport& report);
// What the sensors should read in the next measurement, under each of what it separates.
std::string expected_table(const DiagnosisResult& result);
std::string ranking_table(const CatalogueRanking& ranking);
std::string notes_table(const DiagnosisResult& result);
std::string friction_table(const Hardware& hardware);

// Whether the next measurement is to tell two causes apart.
bool separates_causes(const DiagnosisResult& result);

}  // namespace reeve::pages
