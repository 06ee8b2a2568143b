#include "diagnosis/fit/mounted_draws.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "diagnosis/fit/forecast.hpp"
#include "diagnosis/fit/scatter_samples.hpp"
#include "numerics/chi_squared.hpp"
#include "numerics/random.hpp"

namespace reeve::diagnosis {

MountedDraws::MountedDraws(const Dataset& dataset, const Model& model,
                           const MountingScatter& scatter)
    : model_(model),
      scatter_(scatter),
      cells_(dataset.cells.size()),
      median_reading_N_(median_reading(dataset)),
      channels_(dataset.data->channels.size()) {
  for (std::size_t kind = 0; kind < contact_kinds; ++kind) {
    most_contacts_ =
        std::max(most_contacts_, most_of_a_kind(dataset, static_cast<ContactKind>(kind)));
  }
  const Forecast at = forecast(dataset, model);
  for (Mounting& mounting : mountings(dataset)) {
    std::vector<std::size_t> readings;
    for (const DatasetRow& row : dataset.rows) {
      const Reading& reading = dataset.data->readings[row.reading];
      if (reading.run == mounting.run && reading.routing == mounting.routing) {
        readings.push_back(row.reading);
      }
    }
    Eigen::VectorXd own = at.reading_N(mounting.cells);
    parts_.push_back({std::move(mounting.cells),
                      diagnosis::dataset(*dataset.data, readings, Rows::all), std::move(own)});
  }
}

MountedScatter MountedDraws::of_a_rig(std::uint64_t seed, std::uint32_t stream,
                                      std::uint64_t first) const {
  constexpr double fewest = 4;  // with 2 or fewer, τ' would have no mean square
  MountedScatter result = scatter_.relative;
  for (std::size_t kind = 0; kind < mounted_kinds; ++kind) {
    const double u = uniform(seed, stream, first + kind);
    if (!is_told(scatter_, static_cast<Mounted>(kind))) continue;
    const double degrees = std::max(fewest, scatter_.told_by[kind]);
    result[kind] *= std::sqrt(degrees / chi_squared_quantile(1 - u, degrees));
  }
  return result;
}

Eigen::VectorXd MountedDraws::draw(std::uint64_t seed, std::uint32_t stream,
                                   std::uint64_t first) const {
  Eigen::VectorXd drawn(static_cast<Eigen::Index>(cells_));
  const MountedScatter scatter = of_a_rig(seed, stream, first);
  first += mounted_kinds;
  const double tau = scatter[static_cast<std::size_t>(Mounted::gain)];
  const double zero_N = scatter[static_cast<std::size_t>(Mounted::zero)] * median_reading_N_;
  const std::size_t gains = contact_kinds * most_contacts_;
  const std::size_t zeros = gains + channels_;
  // Contacts by their number among those of their kind, gains and zeros of channels, and at last
  // the motor's gain.
  std::vector<double> z(zeros + channels_ + 1);
  const ChangedExponents exponents([&](double phi, const ContactLoad& load) {
    const std::optional<Mounted> kind = mounted_kind(load.kind);
    if (!kind || load.number >= most_contacts_) return phi;
    const double own = z[static_cast<std::size_t>(load.kind) * most_contacts_ + load.number];
    return phi * std::max(0.0, 1 + scatter[static_cast<std::size_t>(*kind)] * own);
  });
  Model mounted = model_;
  add_effect(mounted, {&exponents, {}, {}});
  for (const Part& part : parts_) {
    for (double& one : z) one = normal(seed, stream, first++);
    const std::optional<Forecast> at = try_forecast(part.dataset, mounted, MotorSlopes::left_out);
    const Eigen::VectorXd& reading_N = at ? at->reading_N : part.reading_N;
    for (const DatasetRow& row : part.dataset.rows) {
      const double motor = row.has_motor_tension ? 1 + tau * z.back() : 1;
      for (std::size_t i = row.first; i < row.last; ++i) {
        const std::size_t channel = part.dataset.cells[i].channel;
        const double own = 1 + tau * z[gains + channel];
        drawn[part.cells[i]] =
            reading_N[static_cast<Eigen::Index>(i)] * motor * own + zero_N * z[zeros + channel];
      }
    }
  }
  return drawn;
}

}  // namespace reeve::diagnosis
