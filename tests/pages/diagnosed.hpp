// Diagnoses to make pages of, and what their pages draw.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "causes/library.hpp"
#include "core/notation.hpp"
#include "pages/diagnosis/diagnosis_page.hpp"
#include "tests/support/read_chart.hpp"

namespace reeve::testing {

// Two routings, readings in two runs of which one is held out.
inline DiagnosisReport plain_report(std::size_t readings = 12) {
  DiagnosisReport report;
  report.data.file = "rig.csv";
  report.data.runs = {"first", "second"};
  for (const char* word : {"M-1-T-2-F", "M-1-P-2-M"}) {
    const Routing routing = parse_routing(word);
    report.data.routings.push_back({word, routing, expand(routing), {}});
  }
  report.data.channels = {{"T1", parse_segment("T1")}, {"T2", parse_segment("T2")}};
  for (std::size_t i = 0; i < readings; ++i) {
    Reading reading;
    reading.line = i + 2;
    reading.run = i % 2;
    reading.routing = i / 2 % 2;
    reading.motor_tension_N = 10 + static_cast<double>(i);
    report.data.readings.push_back(reading);
    for (std::size_t channel = 0; channel < 2; ++channel) {
      report.result.cells.push_back({{i, channel, 0, 3.0}, i % 2 == 1, 2.0, 2.9, 0.1, 0, 0, {}});
    }
  }
  report.result.rows = readings;
  report.result.runs = 2;
  report.result.held_out_runs = 1;
  report.result.noise_limit = NoiseLimit{50, 45, 55, 0.1};
  report.result.run_gains = {{1, readings, 1, 0.1, 0.1}};
  return report;
}

inline const HeldOut gained{1, 0.1, 0.9, 0.8, 0.95, 49, 40, 60, 48};

inline void name_tube_friction(DiagnosisReport& report) {
  NamedCause cause;
  cause.name = "tube_friction";
  cause.meaning = "the friction of the tubes differs";
  cause.effect = {find_cause("tube_friction"), {}, {0.09}};
  cause.parameters = {{"mu", "1", 0.09, 0.08, 0.1, 0.18, Range{0.05, 0.2}}};
  cause.held_out = gained;
  report.result.causes = {cause};
  report.result.held_out = gained;
  report.result.weighed = {{{"wear"}, 20, HeldOut{}}, {{"tube_friction"}, 100, gained}};
  report.result.verdict = Verdict::cause;
}

inline std::string diagnosis_html(const DiagnosisReport& report) {
  return diagnosis_page({report, "reeve diagnose rig.csv --out out", {}}).html;
}

inline bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

inline const std::string& svg_of(const PageFiles& page, const std::string& id) {
  const auto found = std::find_if(page.figures.begin(), page.figures.end(),
                                  [&](const FigureFile& file) { return file.id == id; });
  EXPECT_NE(found, page.figures.end()) << id;
  return found->svg;
}

inline std::vector<ReadPanel> chart_of(const PageFiles& page, const std::string& id) {
  return read_chart(svg_of(page, id));
}

}  // namespace reeve::testing
