#include "studies/tension_distributions.hpp"

#include <algorithm>
#include <cmath>
#include <set>
#include <string_view>
#include <utility>

#include "catalog/fault.hpp"
#include "catalog/number_check.hpp"
#include "core/error.hpp"
#include "core/notation.hpp"
#include "diagnosis/verdict/share_error.hpp"
#include "readings/measured_shares.hpp"
#include "studies/shown_routing.hpp"

namespace reeve::studies {
namespace {

std::vector<Routing> routings_with_shares(const MeasuredData& data) {
  std::vector<Routing> routings;
  std::vector<std::size_t> seen;
  for (const MeasuredShares& group : measured_shares(data).groups) {
    const Routing& routing = data.routings[group.routing].routing;
    if (std::ranges::find(seen, group.routing) != seen.end()) continue;
    seen.push_back(group.routing);
    if (routings.empty() || finger_count(routing) == finger_count(routings.front())) {
      routings.push_back(routing);
    }
  }
  return routings;
}

bool has_coefficient(const Hardware& hardware, double mu) {
  return hardware.tube.mu == mu && hardware.sheath.mu == mu;
}

std::vector<FrictionCase> cases(const Hardware& hardware, const DiagnosisResult& result,
                                const std::vector<PublishedModel>& published) {
  const Model standing{hardware, {}, result.model.conditions};
  std::vector<FrictionCase> list;
  const bool stands_among_them = std::ranges::any_of(
      published, [&](const PublishedModel& model) { return has_coefficient(hardware, model.mu); });
  if (!stands_among_them) list.push_back({FrictionKind::model, standing});
  for (const PublishedModel& model : published) {
    const bool is_there = std::ranges::any_of(list, [&](const FrictionCase& which) {
      return has_coefficient(which.model.hardware, model.mu);
    });
    if (!is_there) list.push_back(with_coefficient(standing, model.mu));
  }
  if (!result.model.effects.empty()) list.push_back({FrictionKind::diagnosed, result.model});
  return list;
}

bool is_coefficient_of_tubes_or_sheaths(const Effect& effect) {
  const std::string_view name = effect.cause->name();
  return name == "tube_friction" || name == "sheath_friction";
}

// Strand by strand; NaN where all are slack. A finger to which a tendon is tied has one.
std::vector<StrandShare> model_shares(const SolvedRouting& report) {
  const ShownGrasp& shown = report.grasps.front();
  std::vector<StrandShare> shares;
  for (int strand = 1; strand <= 2 * report.network.fingers; ++strand) {
    const Segment wanted{SegmentKind::strand, strand, 0};
    const auto found = find_segment(report.network, wanted);
    if (!found) continue;
    shares.push_back({segment_name(wanted),
                      shown.state.tension[*found] / shown.performance.force_transmission,
                      {},
                      {}});
  }
  return shares;
}

std::optional<double> rms_measured(const std::vector<RoutingShares>& routings) {
  double squares = 0;
  std::size_t count = 0;
  for (const RoutingShares& routing : routings) {
    for (const StrandShare& strand : routing.strands) {
      if (!strand.measured || !std::isfinite(strand.model)) continue;
      squares += std::pow(strand.measured->mean - strand.model, 2);
      ++count;
    }
  }
  if (count == 0) return std::nullopt;
  return std::sqrt(squares / static_cast<double>(count));
}

struct Mean {
  double sum = 0;
  std::size_t count = 0;

  void add(double value) {
    sum += value;
    ++count;
  }
  std::optional<double> value() const {
    if (count == 0) return std::nullopt;
    return sum / static_cast<double>(count);
  }
};

MeanShareErrors share_errors(const std::vector<RoutingShares>& routings) {
  Mean of_model;
  Mean of_published;
  for (const RoutingShares& routing : routings) {
    std::vector<double> measured, model, published;
    for (const StrandShare& strand : routing.strands) {
      if (!strand.measured || !std::isfinite(strand.model)) break;
      measured.push_back(strand.measured->mean);
      model.push_back(strand.model);
      if (strand.published) published.push_back(strand.published->share);
    }
    if (measured.empty() || measured.size() < routing.strands.size()) continue;
    of_model.add(distance_to_shares(measured, model));
    if (published.size() == measured.size()) {
      of_published.add(distance_to_shares(measured, published));
    }
  }
  return {of_model.value(), of_published.value()};
}

class Distributions {
 public:
  Distributions(const DistributionRequest& request, const Catalogue& catalogue)
      : request_(request), catalogue_(catalogue), checked_(check(catalogue)) {
    for (const Routing& routing : request.routings) words_.push_back(to_word(routing));
    if (request.data) read_data();
  }

  TensionDistributions run(const std::vector<Grasp>& grasps) {
    TensionDistributions result{{}, data_, 0};
    for (const Grasp& grasp : grasps) {
      for (const FrictionCase& which : request_.cases) result.list.push_back(at(which, grasp));
    }
    result.unconverged = unconverged_;
    return result;
  }

  std::vector<Grasp> with_measured_ones(std::vector<Grasp> grasps) const {
    for (const MeasuredShares& group : measured_) {
      if (std::ranges::find(grasps, group.grasp) == grasps.end()) {
        grasps.push_back(group.grasp);
      }
    }
    return grasps;
  }

 private:
  void read_data() {
    const MeasuredData& data = *request_.data;
    data_ = SharedData{data.file, data.simulated, data.notes};
    SharesOfData shares = measured_shares(data);
    std::set<std::string> others;
    for (MeasuredShares& group : shares.groups) {
      if (is_asked_for(word_of(group))) {
        measured_.push_back(std::move(group));
      } else {
        others.insert(word_of(group));
      }
    }
    data_->notes.insert(data_->notes.end(), shares.notes.begin(), shares.notes.end());
    for (const std::string& word : others) {
      data_->notes.push_back({NoteKind::not_compared,
                              "the readings of " + word +
                                  " are left out: it is not among the routings, written like this",
                              {}});
    }
    const bool with_sheath_angle = std::ranges::any_of(
        data.readings, [](const Reading& reading) { return reading.sheath_angle_rad.has_value(); });
    if (with_sheath_angle) {
      data_->notes.push_back(
          {NoteKind::not_compared,
           "the model's shares are those at the hardware's sheath angles, whatever "
           "sheath_angle_rad says of a reading",
           {}});
    }
    if (measured_.empty()) {
      throw InputError({.where = data.file,
                        .what = "there is nothing to draw",
                        .expected = "readings, pulling, of all strands of one of the routings that "
                                    "are ranked"});
    }
  }

  TensionDistribution at(const FrictionCase& which, Grasp grasp) {
    TensionDistribution result;
    const Hardware hardware = effective_hardware(which.model);
    result.kind = which.kind;
    result.tube_mu = hardware.tube.mu;
    result.sheath_mu = hardware.sheath.mu;
    for (const Effect& effect : which.model.effects) {
      if (!is_coefficient_of_tubes_or_sheaths(effect))
        result.other_effects.push_back(effect_name(effect));
    }
    result.sensors_differ = reaches(which.model, Reach::reading);
    result.grasp = grasp;
    for (const Routing& routing : request_.routings) {
      const SolvedRouting shown =
          solved_routing(routing, which.model, {{grasp, 1}}, Direction::pull, catalogue_);
      unconverged_ += shown.unconverged;
      RoutingShares& shares = result.routings.emplace_back();
      shares.word = shown.word;
      shares.name = shown.name;
      shares.strands = model_shares(shown);
      add_measured(shares, grasp);
    }
    add_published(result);
    result.rms_measured = rms_measured(result.routings);
    result.share_errors = share_errors(result.routings);
    return result;
  }

  // Adds the printed shares for these coefficients; a table has precedence over a figure.
  void add_published(TensionDistribution& distribution) const {
    for (RoutingShares& shares : distribution.routings) {
      for (const CatalogueEntry& entry : catalogue_.entries) {
        if (entry.word != shares.word || !(entry.grasp == distribution.grasp)) continue;
        for (const PrintedList& list : printed_lists(entry)) {
          if (list.kind != PrintedKind::share || list.hardware.tube.mu != distribution.tube_mu ||
              list.hardware.sheath.mu != distribution.sheath_mu ||
              !shares.published_source.empty()) {
            continue;
          }
          shares.published_source = list.source;
          for (std::size_t i = 0; i < shares.strands.size(); ++i) {
            shares.strands[i].published =
                PublishedShare{list.numbers[i].value / 100, fault(entry, list.source, i)};
          }
        }
      }
    }
  }

  void add_measured(RoutingShares& shares, Grasp grasp) const {
    for (const MeasuredShares& group : measured_) {
      if (word_of(group) != shares.word || !(group.grasp == grasp)) continue;
      shares.readings = group.readings;
      for (std::size_t i = 0; i < shares.strands.size(); ++i) {
        shares.strands[i].measured = MeasuredShare{group.mean[i], std::nullopt};
        if (!group.deviation.empty()) shares.strands[i].measured->deviation = group.deviation[i];
      }
    }
  }

  std::string fault(const CatalogueEntry& entry, const std::string& source,
                    std::size_t strand) const {
    const CheckedQuantity quantity{CheckedKind::strand_share, static_cast<int>(strand + 1)};
    for (const CheckItem& item : checked_.items) {
      if (item.routing == entry.name && item.source == source && item.quantity == quantity &&
          item.status != CheckStatus::agrees) {
        return item.reason;
      }
    }
    return "";
  }

  std::string word_of(const MeasuredShares& group) const {
    return request_.data->routings[group.routing].word;
  }
  bool is_asked_for(const std::string& word) const {
    return std::ranges::find(words_, word) != words_.end();
  }

  const DistributionRequest& request_;
  const Catalogue& catalogue_;
  CheckReport checked_;
  std::vector<std::string> words_;
  std::vector<MeasuredShares> measured_;  // shares of the requested routings
  std::optional<SharedData> data_;
  std::uint64_t unconverged_ = 0;
};

}  // namespace

std::optional<TensionDistributions> diagnosed_distributions(
    const MeasuredData& data, const Hardware& hardware, const DiagnosisResult& result,
    const std::vector<PublishedModel>& published, const Catalogue& catalogue) {
  DistributionRequest request{routings_with_shares(data), cases(hardware, result, published), data};
  if (request.routings.empty()) return std::nullopt;
  try {
    return measured_distributions(request, catalogue);
  } catch (const OutOfRange&) {
    return std::nullopt;
  }
}

FrictionCase with_coefficient(Model model, double mu) {
  model.hardware.tube.mu = mu;
  model.hardware.sheath.mu = mu;
  std::erase_if(model.effects, is_coefficient_of_tubes_or_sheaths);
  return {FrictionKind::coefficient, std::move(model)};
}

TensionDistributions tension_distributions(const DistributionRequest& request,
                                           const Catalogue& catalogue) {
  Distributions distributions(request, catalogue);
  const bool one_finger = finger_count(request.routings.front()) == 1;
  return distributions.run(distributions.with_measured_ones({one_finger ? Grasp{} : hold({1})}));
}

TensionDistributions measured_distributions(const DistributionRequest& request,
                                            const Catalogue& catalogue) {
  Distributions distributions(request, catalogue);
  return distributions.run(distributions.with_measured_ones({}));
}

}  // namespace reeve::studies
