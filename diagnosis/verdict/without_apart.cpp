#include "diagnosis/verdict/without_apart.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <utility>

#include "diagnosis/fit/fit.hpp"
#include "diagnosis/verdict/share_error.hpp"

namespace reeve::diagnosis {
namespace {

using Place = std::pair<std::size_t, std::size_t>;  // reading and channel

Place place(const Cell& cell) { return {cell.reading, cell.channel}; }

bool is_at(const ComparedCell& cell, const MeasuredData& data, const Loss& loss,
           const Segment& segment) {
  const Reading& reading = data.readings[cell.cell.reading];
  const Segment& own = data.channels[cell.cell.channel].segment;
  return reading.routing == loss.routing && reading.grasp == loss.grasp &&
         reading.direction == loss.direction && own == segment;
}

// The cells at one end of a stretch.
struct End {
  std::vector<Cell> cells;
  double misfit = 0;
};

End end_of(const MeasuredData& data, const std::vector<ComparedCell>& cells, const Loss& loss,
           const Segment& segment) {
  End end;
  for (const ComparedCell& cell : cells) {
    if (!is_at(cell, data, loss, segment)) continue;
    end.cells.push_back(cell.cell);
    end.misfit += std::abs(cell.cell.measured_N - cell.after_N) / cell.after_N;
  }
  return end;
}

std::vector<Cell> cells_apart(const MeasuredData& data, const std::vector<ComparedCell>& cells,
                              const std::vector<Loss>& losses) {
  std::vector<Cell> apart;
  std::set<Place> known;
  for (const Loss& loss : losses) {
    if (!loss.stands_apart) continue;
    const End high = end_of(data, cells, loss, loss.high);
    const End low = end_of(data, cells, loss, loss.low);
    for (const Cell& cell : (low.misfit >= high.misfit ? low : high).cells) {
      if (known.insert(place(cell)).second) apart.push_back(cell);
    }
  }
  return apart;
}

std::vector<std::size_t> readings_of(const std::vector<ComparedCell>& cells) {
  std::set<std::size_t> readings;
  for (const ComparedCell& cell : cells) readings.insert(cell.cell.reading);
  return {readings.begin(), readings.end()};
}

// None where no reading has all strands, or the model no tensions at one of those that it was not
// fitted to.
std::optional<double> share_error_of(const MeasuredData& data, const Model& model,
                                     std::vector<ComparedCell> cells) {
  const Dataset all = dataset(data, readings_of(cells));
  const std::optional<Forecast> at = try_forecast(all, model);
  if (!at) return std::nullopt;
  std::map<Place, ComparedCell*> at_place;
  for (ComparedCell& cell : cells) at_place[place(cell.cell)] = &cell;
  for (std::size_t i = 0; i < all.cells.size(); ++i) {
    const auto found = at_place.find(place(all.cells[i]));
    if (found == at_place.end()) continue;
    found->second->after_N = at->reading_N[static_cast<Eigen::Index>(i)];
  }
  const ShareErrors errors = share_errors(data, cells);
  if (errors.groups.empty()) return std::nullopt;
  return errors.after;
}

}  // namespace

std::optional<WithoutApart> without_apart(const MeasuredData& data, const Model& model,
                                          Scatter scatter, const std::vector<ComparedCell>& cells,
                                          const std::vector<Loss>& losses, Workers& workers) {
  WithoutApart result;
  result.left_out = cells_apart(data, cells, losses);
  if (result.left_out.empty() || parameter_count(model) == 0) return std::nullopt;
  MeasuredData others = data;
  for (const Cell& cell : result.left_out)
    others.readings[cell.reading].tension_N[cell.channel].reset();
  const Dataset rest = dataset(others, readings_of(cells));
  if (rest.cells.empty()) return std::nullopt;
  Problem known = problem(rest, scatter, model, workers);
  result.model = fit(known, model).model;
  if (scatter.noise.source == NoiseSource::residuals) {
    scatter.noise = noise_left_by(rest, result.model);
    known = problem(rest, scatter, result.model, workers);
    result.model = fit(known, result.model).model;
  }
  result.intervals = parameter_intervals(known, result.model);
  result.share_error = share_error_of(data, result.model, cells);
  return result;
}

}  // namespace reeve::diagnosis
