#include "cli/tension_distributions.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <set>
#include <sstream>
#include <string_view>
#include <utility>

#include "catalog/check.hpp"
#include "cli/inputs.hpp"
#include "cli/shown_routing.hpp"
#include "core/error.hpp"
#include "core/notation.hpp"
#include "diagnosis/measured_shares.hpp"

namespace reeve::cli {
namespace {

constexpr double greatest_mu = 1;
constexpr std::size_t most_coefficients = 6;

Model with_coefficient(Model model, double mu) {
  model.hardware.tube.mu = mu;
  model.hardware.sheath.mu = mu;
  std::erase_if(model.effects, [](const Effect& effect) {
    const std::string_view name = effect.cause->name();
    return name == "tube_friction" || name == "sheath_friction";
  });
  for_option(fmt::format("--mu {}: ", mu), [&] { validate(effective_hardware(model)); });
  return model;
}

// Strand by strand; NaN where all are slack.
std::vector<double> model_shares(const ShowReport& report) {
  const ShownGrasp& shown = report.grasps.front();
  std::vector<double> shares(2 * static_cast<std::size_t>(report.network.fingers));
  for (std::size_t i = 0; i < report.network.segments.size(); ++i) {
    const Segment& segment = report.network.segments[i];
    if (segment.kind != SegmentKind::strand) continue;
    shares[static_cast<std::size_t>(segment.number - 1)] =
        shown.state.tension[i] / shown.performance.force_transmission;
  }
  return shares;
}

class Distributions {
 public:
  Distributions(const DistributionRequest& request, const Catalogue& catalogue)
      : request_(request), catalogue_(catalogue), checked_(check(catalogue)) {
    for (const Routing& routing : request.routings) words_.push_back(to_word(routing));
    if (request.data) read_data();
  }

  TensionDistributions run();

 private:
  void read_data();
  std::vector<Grasp> grasps() const;
  TensionDistribution at(double mu, Grasp grasp);
  RoutingShares shares_of(std::size_t routing, const Model& model, Grasp grasp);
  void add_published(RoutingShares& shares, Grasp grasp) const;
  void add_measured(RoutingShares& shares, Grasp grasp) const;
  std::string fault(const CatalogueEntry& entry, std::size_t strand) const;
  std::string word_of(const MeasuredShares& group) const {
    return request_.data->routings[group.routing].word;
  }
  bool is_asked_for(const std::string& word) const {
    return std::find(words_.begin(), words_.end(), word) != words_.end();
  }

  const DistributionRequest& request_;
  const Catalogue& catalogue_;
  CheckReport checked_;
  std::vector<std::string> words_;
  std::vector<MeasuredShares> measured_;  // of the routings that were asked for
  std::optional<SharedData> data_;
  std::uint64_t unconverged_ = 0;
};

void Distributions::read_data() {
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
  const bool with_sheath_angle =
      std::any_of(data.readings.begin(), data.readings.end(),
                  [](const Reading& reading) { return reading.sheath_angle_rad.has_value(); });
  if (with_sheath_angle) {
    data_->notes.push_back(
        {NoteKind::not_compared,
         "the model's shares are those at the hardware's sheath angles, whatever "
         "sheath_angle_rad says of a reading",
         {}});
  }
  if (measured_.empty()) {
    throw InputError(data.file +
                     ": there is nothing to draw: expected readings, pulling, of all strands of "
                     "one of the routings that are ranked");
  }
}

std::vector<Grasp> Distributions::grasps() const {
  std::vector<Grasp> grasps{finger_count(request_.routings.front()) > 1 ? hold({1}) : Grasp{}};
  for (const MeasuredShares& group : measured_) {
    if (std::find(grasps.begin(), grasps.end(), group.grasp) == grasps.end()) {
      grasps.push_back(group.grasp);
    }
  }
  return grasps;
}

std::string Distributions::fault(const CatalogueEntry& entry, std::size_t strand) const {
  const CheckedQuantity quantity{CheckedKind::strand_share, static_cast<int>(strand + 1)};
  for (const CheckItem& item : checked_.items) {
    if (item.routing == entry.name && item.source == entry.table->source &&
        item.quantity == quantity && item.status != CheckStatus::agrees) {
      return item.reason;
    }
  }
  return "";
}

void Distributions::add_published(RoutingShares& shares, Grasp grasp) const {
  for (const CatalogueEntry& entry : catalogue_.entries) {
    if (entry.word != shares.word || !entry.table || !(entry.grasp == grasp)) continue;
    shares.published_source = entry.table->source;
    for (std::size_t i = 0; i < shares.strands.size(); ++i) {
      shares.strands[i].published =
          PublishedShare{entry.table->share_percent[i].value / 100, fault(entry, i)};
    }
  }
}

void Distributions::add_measured(RoutingShares& shares, Grasp grasp) const {
  for (const MeasuredShares& group : measured_) {
    if (word_of(group) != shares.word || !(group.grasp == grasp)) continue;
    shares.readings = group.readings;
    for (std::size_t i = 0; i < shares.strands.size(); ++i) {
      shares.strands[i].measured = MeasuredShare{group.mean[i], std::nullopt};
      if (!group.deviation.empty()) shares.strands[i].measured->deviation = group.deviation[i];
    }
  }
}

RoutingShares Distributions::shares_of(std::size_t routing, const Model& model, Grasp grasp) {
  const ShowReport report =
      shown_routing(request_.routings[routing], model, {{grasp, 1}}, Direction::pull, catalogue_);
  unconverged_ += report.unconverged;
  RoutingShares shares{report.word, report.name, "", 0, {}};
  for (const double share : model_shares(report)) {
    shares.strands.push_back({fmt::format("T{}", shares.strands.size() + 1), share, {}, {}});
  }
  add_published(shares, grasp);
  add_measured(shares, grasp);
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

TensionDistribution Distributions::at(double mu, Grasp grasp) {
  const Model model = with_coefficient(request_.model, mu);
  TensionDistribution result{mu, grasp, {}, {}};
  for (std::size_t i = 0; i < request_.routings.size(); ++i) {
    result.routings.push_back(shares_of(i, model, grasp));
  }
  result.rms_measured = rms_measured(result.routings);
  return result;
}

TensionDistributions Distributions::run() {
  TensionDistributions result{{}, data_, 0};
  for (const Grasp grasp : grasps()) {
    for (const double mu : request_.mu) result.list.push_back(at(mu, grasp));
  }
  result.unconverged = unconverged_;
  return result;
}

}  // namespace

std::vector<double> parse_coefficients(const std::string& text) {
  const auto refuse = [&](const std::string& what) -> InputError {
    return InputError(fmt::format("--mu '{}': {}", text, what));
  };
  std::vector<double> result;
  std::istringstream items(text + ",");
  for (std::string item; std::getline(items, item, ',');) {
    double mu = std::numeric_limits<double>::quiet_NaN();
    const auto [end, error] = std::from_chars(item.data(), item.data() + item.size(), mu);
    if (error != std::errc{} || end != item.data() + item.size() ||
        !(mu >= 0 && mu <= greatest_mu)) {
      throw refuse(
          fmt::format("'{}': expected friction coefficients from 0 to 1, such as 0.18,0.09", item));
    }
    if (std::find(result.begin(), result.end(), mu) != result.end()) {
      throw refuse(fmt::format("{} is given twice", item));
    }
    result.push_back(mu);
  }
  if (result.size() > most_coefficients) {
    throw refuse(fmt::format("expected at most {} coefficients", most_coefficients));
  }
  return result;
}

TensionDistributions tension_distributions(const DistributionRequest& request,
                                           const Catalogue& catalogue) {
  return Distributions(request, catalogue).run();
}

}  // namespace reeve::cli
