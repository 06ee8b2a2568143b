// What the template of a diagnosis' page is filled with, but for its figures.
#pragma once

#include "pages/diagnosis/diagnosis_marks.hpp"
#include "pages/diagnosis/diagnosis_page.hpp"

namespace reeve::pages {

// The answer: verdict, shape and sentences.
Json answer_values(const DiagnosisReport& report);

// Tables and sentences of the causes: named, weighed, gains, what cannot be told apart.
Json cause_values(const DiagnosisReport& report);

// What the residuals could follow, and which columns there are not.
Json structure_values(const DiagnosisReport& report, const MarkColumns& columns);

// The next measurement, without its schematic.
Json next_values(const DiagnosisReport& report);

// The data with their notes, the settings and what is beside the page.
Json data_values(const DiagnosisPageInput& input);

}  // namespace reeve::pages
