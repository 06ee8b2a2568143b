#include "studies/published_models.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <optional>
#include <utility>

#include "catalog/fault.hpp"
#include "catalog/solution.hpp"
#include "core/canonical.hpp"
#include "diagnosis/verdict/share_error.hpp"
#include "readings/measured_shares.hpp"

namespace reeve::studies {
namespace {

// Within this, lines and equations say the same of a stretch: a tenth of what a sheath loses.
constexpr double same_loss = 0.05;

const CatalogueEntry* entry_of(const Catalogue& catalogue, const MeasuredRouting& routing) {
  return catalogue.find_word(canonical(routing.routing, FingerIdentity::identical));
}

// The strands of the data's word are those of the catalogue's only if it is written like it.
bool is_published(const CatalogueEntry* entry, const MeasuredRouting& routing, Grasp grasp) {
  return entry != nullptr && entry->word == routing.word && entry->grasp == grasp;
}

// Tables of several routings are one model, and so are the lines of one figure.
std::string place_of(const PrintedList& list) { return list.drawn ? list.source : ""; }

int sheaths_in(const std::vector<ContactKind>& contacts) {
  return static_cast<int>(std::ranges::count(contacts, ContactKind::sheath));
}

// Sheath losses that listed faults leave out between two strands.
int left_out(const CatalogueEntry& entry, int high, int low) {
  int count = 0;
  for (const Fault& fault : entry.faults) {
    const auto* factor = std::get_if<FactorFault>(&fault.what);
    if (factor == nullptr) continue;
    if (concerns(*factor, low) && !concerns(*factor, high)) count += factor->left_out.sheath;
  }
  return count;
}

std::optional<PublishedLoss> differing_loss(const CatalogueEntry& entry, const Loss& loss,
                                            const std::vector<double>& printed,
                                            const std::vector<double>& equations) {
  if (loss.high.kind != SegmentKind::strand || loss.low.kind != SegmentKind::strand) return {};
  const auto high = static_cast<std::size_t>(loss.high.number - 1);
  const auto low = static_cast<std::size_t>(loss.low.number - 1);
  PublishedLoss result;
  result.printed = std::log(printed[high] / printed[low]);
  result.equations = std::log(equations[high] / equations[low]);
  result.sheaths = sheaths_in(loss.over);
  result.sheaths_drawn = result.sheaths - left_out(entry, loss.high.number, loss.low.number);
  if (std::abs(result.printed - result.equations) < same_loss) return {};
  return result;
}

void add_losses(const DiagnosisResult& result, const ShareError& group, const CatalogueEntry& entry,
                const std::vector<double>& printed, const std::vector<double>& equations,
                PublishedModel& model) {
  for (std::size_t i = 0; i < result.losses.size(); ++i) {
    const Loss& loss = result.losses[i];
    if (loss.routing != group.routing || !(loss.grasp == group.grasp) ||
        loss.direction != Direction::pull) {
      continue;
    }
    auto found = differing_loss(entry, loss, printed, equations);
    if (!found) continue;
    found->loss = i;
    model.losses.push_back(*found);
  }
}

// The rows that the group's error of the diagnosis is the mean over.
std::vector<std::vector<double>> rows_of(const MeasuredData& data, const ShareError& group) {
  std::vector<std::vector<double>> rows;
  for (const Reading& reading : data.readings) {
    if (reading.routing != group.routing || reading.grasp != group.grasp ||
        reading.direction != Direction::pull) {
      continue;
    }
    auto strands = strand_tensions(data, reading);
    const auto is_taut = [](double tension) { return tension > 0; };
    if (strands && std::ranges::any_of(*strands, is_taut)) {
      rows.push_back(std::move(*strands));
    }
  }
  return rows;
}

double mean_distance(const std::vector<std::vector<double>>& rows,
                     const std::vector<double>& shares) {
  double sum = 0;
  for (const std::vector<double>& row : rows) sum += distance_to_shares(row, shares);
  return sum / static_cast<double>(rows.size());
}

std::vector<double> shares_of(std::vector<double> tensions) {
  const double whole = std::accumulate(tensions.begin(), tensions.end(), 0.0);
  for (double& tension : tensions) tension /= whole;
  return tensions;
}

// A coefficient, the greatest first, and one figure or all tables.
using ModelKey = std::pair<double, std::string>;

ModelKey key_of(const PrintedList& list) { return {-list.hardware.tube.mu, place_of(list)}; }

// "Table I, Table IV"; "Table I to Table VII" of three or more between which the catalogue has
// none.
std::string name_of(const PublishedModel& model, const ModelKey& key, const Catalogue& catalogue) {
  std::vector<std::string> sources;
  std::vector<bool> used;
  for (const CatalogueEntry& entry : catalogue.entries) {
    for (const PrintedList& list : printed_lists(entry)) {
      if (list.kind != PrintedKind::share || key_of(list) != key ||
          std::ranges::find(sources, list.source) != sources.end()) {
        continue;
      }
      sources.push_back(list.source);
      used.push_back(std::ranges::any_of(
          model.lines, [&](const PublishedLine& line) { return line.source == list.source; }));
    }
  }
  const auto first = std::ranges::find(used, true);
  const auto last = std::find(used.rbegin(), used.rend(), true).base();
  const auto at = [&](auto place) { return sources.begin() + (place - used.begin()); };
  if (last - first > 2 && std::find(first, last, false) == last) {
    return *at(first) + " to " + *(at(last) - 1);
  }
  std::string name;
  for (auto place = first; place != last; ++place) {
    if (*place) name += (name.empty() ? "" : ", ") + *at(place);
  }
  return name;
}

}  // namespace

std::vector<PublishedModel> published_models(const Catalogue& catalogue, const MeasuredData& data,
                                             const DiagnosisResult& result) {
  if (data.simulated) return {};  // simulated data have no publication
  std::map<ModelKey, PublishedModel> models;
  const std::vector<ShareError>& groups = result.share_errors.groups;
  for (std::size_t g = 0; g < groups.size(); ++g) {
    const MeasuredRouting& routing = data.routings[groups[g].routing];
    const CatalogueEntry* entry = entry_of(catalogue, routing);
    if (!is_published(entry, routing, groups[g].grasp)) continue;
    const std::vector<std::vector<double>> rows = rows_of(data, groups[g]);
    for (const PrintedList& list : printed_lists(*entry)) {
      if (list.kind != PrintedKind::share) continue;
      PublishedModel& model = models[key_of(list)];
      model.mu = list.hardware.tube.mu;
      PublishedLine line{g, list.source, {}, 0, 0};
      for (const PrintedNumber& number : list.numbers) line.shares.push_back(number.value / 100);
      const std::vector<double> equations = solve(*entry, list.hardware).tension;
      line.error = mean_distance(rows, line.shares);
      line.equations = mean_distance(rows, shares_of(equations));
      add_losses(result, groups[g], *entry, line.shares, equations, model);
      model.lines.push_back(std::move(line));
    }
  }
  std::vector<PublishedModel> list;
  for (auto& [key, model] : models) {
    model.name = name_of(model, key, catalogue);
    for (const PublishedLine& line : model.lines) {
      model.error += line.error / static_cast<double>(model.lines.size());
      model.equations += line.equations / static_cast<double>(model.lines.size());
    }
    list.push_back(std::move(model));
  }
  return list;
}

}  // namespace reeve::studies
