// Values of the template of a diagnosis' page, without its figures.
#pragma once

#include <string>

#include "pages/diagnosis/diagnosis_marks.hpp"
#include "pages/diagnosis/diagnosis_page.hpp"

namespace reeve::pages {

// The answer: verdict, shape and sentences.
Json answer_values(const DiagnosisReport& report);

// Tables and sentences of the causes: named, weighed, gains, what cannot be told apart.
Json cause_values(const DiagnosisReport& report);

// Patterns that the residuals could follow, and the columns that are missing.
Json structure_values(const DiagnosisReport& report, const MarkColumns& columns);

// The next measurement, without its schematic.
Json next_values(const DiagnosisReport& report);

// The data with their notes, the settings and what is beside the page.
Json data_values(const DiagnosisPageInput& input);

// Tables as HTML; "" of those that have no row.

// The named terms, at most six, by what each explains of the residuals.
std::string findings_table(const DiagnosisReport& report);
std::string sizes_table(const DiagnosisResult& result);
// Estimates of the free friction coefficients, whether or not they are causes.
std::string calibration_table(const DiagnosisResult& result);
std::string groups_table(const DiagnosisReport& report);
// Every model that was weighed, the named one marked in words and by its sign.
std::string weighed_table(const DiagnosisResult& result);
std::string gains_table(const DiagnosisResult& result);
std::string structure_table(const DiagnosisReport& report);
// Expected readings of the sensors in the next measurement, by each explanation that it separates.
std::string expected_table(const DiagnosisResult& result);
std::string ranking_table(const CatalogueRanking& ranking);
std::string notes_table(const DiagnosisResult& result);
std::string friction_table(const Hardware& hardware);

// True if the next measurement is to tell two causes apart.
bool separates_causes(const DiagnosisResult& result);

}  // namespace reeve::pages
