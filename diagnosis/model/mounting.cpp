#include "diagnosis/model/mounting.hpp"

#include <algorithm>
#include <map>
#include <optional>
#include <utility>

#include "diagnosis/model/forecast.hpp"

namespace reeve::diagnosis {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

bool is_of(Mounted kind, ContactKind contact) {
  switch (kind) {
    case Mounted::sheath:
      return contact == ContactKind::sheath;
    case Mounted::tube:
      return contact == ContactKind::tube;
    case Mounted::bearing:
      return is_bearing(contact);
    case Mounted::gain:
      break;
  }
  return false;
}

// The exponent of the n-th contact of a kind, in every routing: no cause that anybody would name,
// but what differs between mountings.
class OneExponent final : public Cause {
 public:
  OneExponent(ContactKind kind, std::size_t number) : kind_(kind), number_(number) {}

  const char* name() const override { return "exponent_of_one_contact"; }
  Reach reach() const override { return Reach::conditions; }
  const char* meaning() const override { return "one contact's friction is another one"; }
  std::vector<Parameter> parameters(const Hardware&) const override {
    return {{"change", "1", 0, {-1, 1}, {}}};
  }
  std::vector<Subject> subjects(const Survey&) const override { return {}; }
  double exponent(double phi, const ContactLoad& load, const Conditions&,
                  const Effect& effect) const override {
    const bool is_it = load.kind == kind_ && load.number == number_;
    return is_it ? phi * (1 + effect.values[0]) : phi;
  }

 private:
  ContactKind kind_;
  std::size_t number_;
};

std::size_t most_of_a_kind(const Dataset& dataset, ContactKind kind) {
  std::size_t most = 0;
  for (const Block& block : dataset.blocks) {
    const auto& contacts = dataset.data->routings[block.routing].network.contacts;
    const auto count = std::count_if(contacts.begin(), contacts.end(),
                                     [&](const auto& contact) { return contact.kind == kind; });
    most = std::max(most, static_cast<std::size_t>(count));
  }
  return most;
}

std::optional<VectorXd> forecast_at(const Dataset& dataset, const Model& model, const Cause& cause,
                                    double change) {
  Model moved = model;
  add_effect(moved, {&cause, {}, {change}});
  auto at = try_forecast(dataset, moved);
  if (!at) return std::nullopt;
  return std::move(at->reading_N);
}

void add_exponents(const Dataset& dataset, const Model& model, Mounted kind, ContactKind contact,
                   std::vector<std::pair<Mounted, VectorXd>>& columns) {
  constexpr double step = 1e-4;
  const std::size_t most = most_of_a_kind(dataset, contact);
  for (std::size_t number = 0; number < most; ++number) {
    const OneExponent cause(contact, number);
    const auto above = forecast_at(dataset, model, cause, step);
    const auto below = forecast_at(dataset, model, cause, -step);
    if (above && below) columns.emplace_back(kind, (*above - *below) / (2 * step));
  }
}

void add_gains(const Dataset& dataset, const VectorXd& reading,
               std::vector<std::pair<Mounted, VectorXd>>& columns) {
  const std::size_t channels = dataset.data->channels.size();
  std::vector<VectorXd> own(channels, VectorXd::Zero(reading.size()));
  VectorXd motor = VectorXd::Zero(reading.size());
  for (const DatasetRow& row : dataset.rows) {
    for (std::size_t i = row.first; i < row.last; ++i) {
      const auto k = static_cast<Index>(i);
      own[dataset.cells[i].channel][k] = reading[k];
      if (row.has_motor_tension) motor[k] = reading[k];
    }
  }
  for (VectorXd& column : own) columns.emplace_back(Mounted::gain, std::move(column));
  columns.emplace_back(Mounted::gain, std::move(motor));
}

}  // namespace

const char* mounted_name(Mounted kind) {
  switch (kind) {
    case Mounted::sheath:
      return "sheath";
    case Mounted::tube:
      return "tube";
    case Mounted::bearing:
      return "bearing";
    case Mounted::gain:
      return "gain";
  }
  return "";
}

std::vector<Mounting> mountings(const Dataset& dataset) {
  std::map<std::pair<std::size_t, std::size_t>, Mounting> found;
  for (const DatasetRow& row : dataset.rows) {
    const Reading& reading = dataset.data->readings[row.reading];
    Mounting& mounting = found[{reading.run, reading.routing}];
    mounting.run = reading.run;
    mounting.routing = reading.routing;
    for (std::size_t i = row.first; i < row.last; ++i) {
      mounting.cells.push_back(static_cast<Index>(i));
    }
  }
  std::vector<Mounting> result;
  for (auto& [key, mounting] : found) result.push_back(std::move(mounting));
  return result;
}

MountingModes mounting_modes(const Dataset& dataset, const Model& model) {
  const auto at = try_forecast(dataset, model);
  MountingModes modes;
  modes.by_share_N.resize(static_cast<Index>(dataset.cells.size()), 0);
  if (!at) return modes;
  std::vector<std::pair<Mounted, VectorXd>> columns;
  for (const Mounted kind : {Mounted::sheath, Mounted::tube, Mounted::bearing}) {
    for (std::size_t c = 0; c < contact_kinds; ++c) {
      const auto contact = static_cast<ContactKind>(c);
      if (is_of(kind, contact)) add_exponents(dataset, model, kind, contact, columns);
    }
  }
  add_gains(dataset, at->reading_N, columns);
  const double rounding = 1e-9 * at->reading_N.norm();
  std::erase_if(columns, [&](const auto& column) { return column.second.norm() <= rounding; });
  modes.by_share_N.resize(at->reading_N.size(), static_cast<Index>(columns.size()));
  for (std::size_t c = 0; c < columns.size(); ++c) {
    modes.kind.push_back(columns[c].first);
    modes.by_share_N.col(static_cast<Index>(c)) = columns[c].second;
  }
  return modes;
}

}  // namespace reeve::diagnosis
