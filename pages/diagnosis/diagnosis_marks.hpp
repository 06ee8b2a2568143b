// The compared readings as charts take them: one mark for each measured tension, a part of them
// where they are many.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "reports/diagnosis/diagnosis_report.hpp"

namespace reeve::pages {

struct ReadingMark {
  const Reading* reading = nullptr;
  double measured_N = 0;
  double before_N = 0;         // by the nominal model
  double after_N = 0;          // by the extended one
  double residual_before = 0;  // sd of the noise
  double residual_after = 0;
  bool held_out = false;
  std::string routing;
  std::string strand;
  std::string grasp;  // "" on a bench
  std::string run;
};

// Something that residuals can follow: one of the mark's texts, or a number of its reading.
struct MarkColumn {
  std::string id;  // for the figure
  std::string title;
  std::string ReadingMark::*category = nullptr;
  std::function<std::optional<double>(const Reading&)> number;
};

struct MarkColumns {
  std::vector<MarkColumn> shown;
  std::vector<std::string> missing;   // columns that the file does not have
  std::vector<std::string> constant;  // columns that never change, with their value
  std::size_t not_drawn = 0;          // columns beyond the limit of a page
};

MarkColumns mark_columns(const DiagnosisReport& report);

// At most this many, drawn by a fixed rule from all; all where they are fewer. They point into the
// report.
std::vector<ReadingMark> marks(const DiagnosisReport& report, std::size_t most);

}  // namespace reeve::pages
