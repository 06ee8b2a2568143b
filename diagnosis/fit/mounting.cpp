#include "diagnosis/fit/mounting.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <numbers>
#include <optional>
#include <utility>

#include "diagnosis/fit/forecast.hpp"
#include "diagnosis/fit/scatter_samples.hpp"

namespace reeve::diagnosis {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

// True if some routing has both contacts; otherwise their joint effect is the sum of the single
// ones.
bool stand_together(const Dataset& dataset, const NumberedContact& a, const NumberedContact& b) {
  const auto has = [](const Network& network, const NumberedContact& contact) {
    const auto count = std::ranges::count(network.contacts, contact.kind, &Contact::kind);
    return static_cast<std::size_t>(count) > contact.number;
  };
  return std::ranges::any_of(dataset.blocks, [&](const ReadingBlock& block) {
    const Network& network = dataset.data->routings[block.routing].network;
    return has(network, a) && has(network, b);
  });
}

// The exponents that differ between mountings, with their columns.
class Exponents {
 public:
  Exponents(const Dataset& dataset, const Model& model, const VectorXd& at, Workers& workers)
      : dataset_(dataset), model_(model), at_(at), workers_(workers) {
    for (const Mounted kind : {Mounted::sheath, Mounted::tube, Mounted::bearing}) {
      for (std::size_t c = 0; c < contact_kinds; ++c) {
        const auto contact = static_cast<ContactKind>(c);
        if (mounted_kind(contact) == kind) list(kind, contact);
      }
    }
    workers_.for_each_block(ones_.size(), 1,
                            [&](const IndexBlock& block) { move(ones_[block.begin]); });
    std::erase_if(ones_,
                  [&](const One& one) { return !(one.change_N.norm() > 1e-9 * at_.norm()); });
  }

  void put(MountingModes& modes, std::vector<VectorXd>& columns) const {
    for (const One& one : ones_) {
      modes.kind.push_back(one.kind);
      columns.push_back(one.change_N);
    }
    std::vector<std::pair<std::size_t, std::size_t>> pairs;
    for (std::size_t a = 0; a < ones_.size(); ++a) {
      for (std::size_t b = 0; b <= a; ++b) {
        if (stand_together(dataset_, ones_[a].contact, ones_[b].contact)) pairs.emplace_back(a, b);
      }
    }
    std::vector<std::optional<MountingModes::Pair>> moved(pairs.size());
    workers_.for_each_block(pairs.size(), 1, [&](const IndexBlock& block) {
      moved[block.begin] =
          together(ones_[pairs[block.begin].first], ones_[pairs[block.begin].second]);
    });
    for (auto& pair : moved) {
      if (pair) modes.pairs.push_back(std::move(*pair));
    }
  }

 private:
  static constexpr double small = 1e-4;
  static constexpr double wide = 0.02;  // so that rounding is no second derivative

  struct One {
    Mounted kind = Mounted::sheath;
    NumberedContact contact;
    VectorXd change_N;               // empty if there are no tensions beside it
    std::optional<VectorXd> wide_N;  // after a wide step
  };

  using Step = std::pair<NumberedContact, double>;  // a relative change of its exponent

  std::optional<VectorXd> moved(const std::vector<Step>& steps) const {
    const ChangedExponents exponents([&](double phi, const ContactLoad& load) {
      for (const auto& [contact, change] : steps) {
        if (contact.is(load)) phi *= 1 + change;
      }
      return phi;
    });
    Model model = model_;
    add_effect(model, {&exponents, {}, {}});
    auto there = try_forecast(dataset_, model, MotorSlopes::left_out);
    if (!there) return std::nullopt;
    return std::move(there->reading_N);
  }

  void list(Mounted kind, ContactKind contact) {
    const std::size_t most = most_of_a_kind(dataset_, contact);
    for (std::size_t number = 0; number < most; ++number) {
      ones_.push_back({kind, {contact, number}, {}, {}});
    }
  }

  void move(One& one) const {
    const auto above = moved({{one.contact, small}});
    const auto below = moved({{one.contact, -small}});
    if (!above || !below) return;
    one.change_N = (*above - *below) / (2 * small);
    one.wide_N = moved({{one.contact, wide}});
  }

  std::optional<MountingModes::Pair> together(const One& first, const One& second) const {
    const bool alone = &first == &second;
    const auto both = alone ? moved({{first.contact, -wide}})
                            : moved({{first.contact, wide}, {second.contact, wide}});
    if (!first.wide_N || !second.wide_N || !both) return std::nullopt;
    const VectorXd change = alone
                                ? VectorXd((*both + *first.wide_N - 2 * at_) / std::numbers::sqrt2)
                                : VectorXd(*both - *first.wide_N - *second.wide_N + at_);
    return MountingModes::Pair{first.kind, second.kind, change / (wide * wide)};
  }

  const Dataset& dataset_;
  const Model& model_;
  const VectorXd& at_;
  Workers& workers_;
  std::vector<One> ones_;
};

// The columns that change something.
void put(Mounted kind, std::vector<VectorXd> own, MountingModes& modes,
         std::vector<VectorXd>& columns) {
  for (VectorXd& column : own) {
    if (column.isZero(0)) continue;
    modes.kind.push_back(kind);
    columns.push_back(std::move(column));
  }
}

std::vector<VectorXd> gains(const Dataset& dataset, const VectorXd& reading) {
  const std::size_t channels = dataset.data->channels.size();
  std::vector<VectorXd> result(channels + 1, VectorXd::Zero(reading.size()));
  for (const DatasetRow& row : dataset.rows) {
    for (std::size_t i = row.first; i < row.last; ++i) {
      const auto k = static_cast<Index>(i);
      result[dataset.cells[i].channel][k] = reading[k];
      if (row.has_motor_tension) result[channels][k] = reading[k];
    }
  }
  return result;
}

// A few readings of one mounting do not tell a zero from a gain, or from their noise.
std::vector<VectorXd> zeros(const Dataset& dataset) {
  constexpr std::size_t enough = 8;
  const auto cells = static_cast<Index>(dataset.cells.size());
  const double median_N = median_reading(dataset);
  std::vector<VectorXd> result(dataset.data->channels.size(), VectorXd::Zero(cells));
  for (const Mounting& mounting : mountings(dataset)) {
    std::vector<std::vector<Index>> of_channel(result.size());
    for (const Index i : mounting.cells) {
      of_channel[dataset.cells[static_cast<std::size_t>(i)].channel].push_back(i);
    }
    for (std::size_t channel = 0; channel < result.size(); ++channel) {
      if (of_channel[channel].size() < enough) continue;
      for (const Index i : of_channel[channel]) result[channel][i] = median_N;
    }
  }
  return result;
}

}  // namespace

std::optional<Mounted> mounted_kind(ContactKind contact) {
  if (is_bearing(contact)) return Mounted::bearing;
  if (contact == ContactKind::sheath) return Mounted::sheath;
  if (contact == ContactKind::tube) return Mounted::tube;
  return std::nullopt;
}

std::size_t most_of_a_kind(const Dataset& dataset, ContactKind kind) {
  std::size_t most = 0;
  for (const ReadingBlock& block : dataset.blocks) {
    const auto& contacts = dataset.data->routings[block.routing].network.contacts;
    const auto count =
        std::ranges::count_if(contacts, [&](const auto& contact) { return contact.kind == kind; });
    most = std::max(most, static_cast<std::size_t>(count));
  }
  return most;
}

const char* mounted_name(Mounted kind) {
  constexpr std::array names{"sheath", "tube", "bearing", "gain", "zero"};
  return names[static_cast<std::size_t>(kind)];
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

MountingModes mounting_modes(const Dataset& dataset, const Model& model, Workers& workers) {
  const auto at = try_forecast(dataset, model);
  MountingModes modes;
  modes.by_share_N.resize(static_cast<Index>(dataset.cells.size()), 0);
  if (!at) return modes;
  std::vector<VectorXd> columns;
  Exponents(dataset, model, at->reading_N, workers).put(modes, columns);
  put(Mounted::gain, gains(dataset, at->reading_N), modes, columns);
  put(Mounted::zero, zeros(dataset), modes, columns);
  modes.by_share_N.resize(at->reading_N.size(), static_cast<Index>(columns.size()));
  for (std::size_t c = 0; c < columns.size(); ++c) {
    modes.by_share_N.col(static_cast<Index>(c)) = columns[c];
  }
  return modes;
}

}  // namespace reeve::diagnosis
