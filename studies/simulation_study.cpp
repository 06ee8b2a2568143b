#include "studies/simulation_study.hpp"

#include "core/notation.hpp"
#include "diagnosis/diagnose.hpp"
#include "readings/measured_data.hpp"
#include "readings/row_order.hpp"

namespace reeve::studies {
namespace {

MeasuredData read_back(const SimulationReport& report, const WrittenSimulation& written) {
  ReadingOptions options;
  const double of_motor = report.noise.motor_relative;
  if (of_motor > 0) options.noise.push_back({"motor", {.relative = of_motor}});
  const auto resolve = [&](const std::string& text) {
    for (const PlannedRouting& routing : report.plan.routings) {
      if (routing.label == text) return routing.routing;
    }
    return parse_routing(text);
  };
  return in_order_of_contents(
      parse_measured_data(written(report), "simulated readings", resolve, options));
}

}  // namespace

std::optional<PowerReport> power_study(SimulationReport experiment, std::size_t experiments,
                                       const WrittenSimulation& written,
                                       const StudySupervision& supervision) {
  PowerReport report;
  report.experiment = experiment;
  std::vector<std::string> hidden;
  for (const Effect& effect : experiment.model.effects) hidden.push_back(effect_name(effect));
  const Supervision diagnosing = supervision.during("diagnosing");
  DiagnoseOptions options;
  options.stop = supervision.stop;
  for (std::size_t i = 0; i < experiments; ++i) {
    if (diagnosing.report) diagnosing.report({i, experiments});
    experiment.seed = report.experiment.seed + i;
    experiment.simulation =
        simulate(experiment.plan, experiment.model, experiment.noise, experiment.seed);
    options.seed = experiment.seed;
    const std::optional<DiagnosisResult> result =
        diagnose_until(read_back(experiment, written), experiment.model.hardware, options);
    if (!result || supervision.stopped()) return std::nullopt;
    report.trials.push_back(judged(experiment.seed, *result, hidden));
  }
  return report;
}

}  // namespace reeve::studies
