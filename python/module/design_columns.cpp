#include "python/module/design_columns.hpp"

#include <fmt/format.h>
#include <pybind11/numpy.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "python/module/bindings.hpp"
#include "reports/jam_words.hpp"
#include "search/evaluate/objectives.hpp"
#include "search/uncertainty/bands.hpp"

namespace reeve::python {
namespace {

using studies::ListedDesign;
using Designs = std::vector<ListedDesign>;

constexpr double nothing = std::numeric_limits<double>::quiet_NaN();

// One value of each design.
template <typename Value, typename Of>
py::array_t<Value> numbers(const Designs& designs, Of of) {
  py::array_t<Value> column(static_cast<py::ssize_t>(designs.size()));
  std::transform(designs.begin(), designs.end(), column.mutable_data(), of);
  return column;
}

template <typename Of>
py::list texts(const Designs& designs, Of of) {
  py::list column;
  for (const ListedDesign& design : designs) column.append(py::str(of(design)));
  return column;
}

double finite(double value) { return std::isfinite(value) ? value : nothing; }

template <typename Of>
py::array_t<double> of_distribution(const Designs& designs, Of of) {
  return numbers<double>(designs, [&](const ListedDesign& design) {
    return design.distribution ? of(*design.distribution) : nothing;
  });
}

void add_objectives(py::dict& columns, const Designs& designs) {
  if (designs.empty()) return;
  const ObjectiveValues& first = designs.front().ranked.design.values;
  for (const ObjectiveRow& row : objective_table()) {
    if (!is_there(row, first)) continue;
    const auto of = [&](const ListedDesign& design) {
      return value(design.ranked.design.values, row.objective);
    };
    if (row.is_count()) {
      columns[row.name] = numbers<std::int64_t>(
          designs, [&](const ListedDesign& d) { return static_cast<std::int64_t>(of(d)); });
    } else {
      columns[row.name] =
          numbers<double>(designs, [&](const ListedDesign& d) { return finite(of(d)); });
    }
  }
}

void add_bands(py::dict& columns, const Designs& designs) {
  const search::Bands& first = designs.front().bands;
  for (std::size_t i = 0; i < first.size(); ++i) {
    const std::string name = row(first[i].objective).name;
    const auto add = [&](const char* part, double search::Band::*of) {
      columns[fmt::format("{}_{}", name, part).c_str()] =
          numbers<double>(designs, [&](const ListedDesign& design) {
            return design.bands.empty() ? nothing : finite(design.bands[i].band.*of);
          });
    };
    add("median", &search::Band::median);
    add("p5", &search::Band::low);
    add("p95", &search::Band::high);
  }
}

}  // namespace

py::dict design_columns(const Designs& designs) {
  using search::RankDistribution;
  py::dict columns;
  columns["rank"] = numbers<std::int64_t>(
      designs, [](const ListedDesign& d) { return static_cast<std::int64_t>(d.ranked.rank); });
  columns["front"] =
      numbers<std::int64_t>(designs, [](const ListedDesign& d) { return d.ranked.front; });
  columns["routing"] = texts(designs, [](const ListedDesign& d) { return d.ranked.design.word; });
  columns["name"] = texts(designs, [](const ListedDesign& d) { return d.name; });
  add_objectives(columns, designs);
  const bool drawn = std::ranges::any_of(
      designs, [](const ListedDesign& d) { return d.distribution.has_value(); });
  if (drawn) {
    columns["first_share"] =
        of_distribution(designs, [](const RankDistribution& d) { return d.first; });
    columns["rank_median"] =
        of_distribution(designs, [](const RankDistribution& d) { return d.median; });
    columns["rank_p5"] = of_distribution(designs, [](const RankDistribution& d) { return d.low; });
    columns["rank_p95"] =
        of_distribution(designs, [](const RankDistribution& d) { return d.high; });
  }
  columns["smallest_jams"] =
      texts(designs, [](const ListedDesign& d) { return reports::jams_field(d.smallest_jams); });
  columns["same_as"] = texts(designs, [](const ListedDesign& d) { return d.same_as; });
  columns["place"] = numbers<std::int64_t>(
      designs, [](const ListedDesign& d) { return static_cast<std::int64_t>(d.place); });
  if (drawn) {
    columns["first_shared"] =
        of_distribution(designs, [](const RankDistribution& d) { return d.first_shared; });
    add_bands(columns, designs);
  }
  if (!designs.empty() && designs.front().constraints_met) {
    columns["constraints_met"] = numbers<double>(
        designs, [](const ListedDesign& d) { return d.constraints_met.value_or(nothing); });
  }
  return columns;
}

py::dict objective_units() {
  py::dict units;
  for (const ObjectiveRow& row : objective_table()) units[row.name] = row.unit;
  return units;
}

}  // namespace reeve::python
