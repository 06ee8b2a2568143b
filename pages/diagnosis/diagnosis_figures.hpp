// The figures of a diagnosis' page.
#pragma once

#include <vector>

#include "pages/diagnosis/diagnosis_marks.hpp"
#include "pages/shell/page.hpp"
#include "reports/diagnosis/diagnosis_report.hpp"

namespace reeve::pages {

// Measured over predicted tension, before and after, on the same scales.
Figure compared_figure(const DiagnosisReport& report, const std::vector<ReadingMark>& marks);

// The same on logarithmic scales, where the small tensions are not one spot in the corner.
Figure compared_logarithmic_figure(const DiagnosisReport& report,
                                   const std::vector<ReadingMark>& marks);

// Residuals in standard deviations of the noise, along one column.
Figure residual_figure(const DiagnosisReport& report, const std::vector<ReadingMark>& marks,
                       const MarkColumn& column);

// Draws the partial residuals of a term over what the term follows, with the fitted curve.
Figure partial_figure(const DiagnosisReport& report, const std::string& id, const std::string& name,
                      const PartialResiduals& partial);

// Each weighed model's gain on held-out runs, beside what the noise allows; on the training runs
// where none were held out.
Figure weighed_figure(const DiagnosisReport& report);

// Each held-out run's residuals, before and after.
Figure runs_figure(const DiagnosisReport& report);

// A parameter's estimate with its interval, beside its nominal value and the literature's range.
Figure parameters_figure(const DiagnosisReport& report);

// Height of a chart's named row.
inline constexpr double row_px = 26;

// Returns the caption of a figure that may draw a part of all points.
std::string thinned_text(const DiagnosisReport& report, std::size_t drawn);

}  // namespace reeve::pages
