#include "studies/published_models.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <utility>

#include "catalog/fault.hpp"
#include "catalog/solution.hpp"
#include "core/canonical.hpp"
#include "diagnosis/data/measured_shares.hpp"

namespace reeve {
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
  return static_cast<int>(std::count(contacts.begin(), contacts.end(), ContactKind::sheath));
}

// Sheath losses that listed faults leave out between two strands.
int left_out(const CatalogueEntry& entry, int high, int low) {
  int count = 0;
  for (const Fault& fault : entry.faults) {
    const auto* factor = std::get_if<FactorFault>(&fault.what);
    if (factor == nullptr) continue;
    const auto concerns = [&](int strand) {
      return std::find(factor->strands.begin(), factor->strands.end(), strand) !=
             factor->strands.end();
    };
    if (concerns(low) && !concerns(high)) count += factor->left_out.sheath;
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

}  // namespace

std::vector<PublishedModel> published_models(const Catalogue& catalogue, const MeasuredData& data,
                                             const DiagnosisResult& result) {
  if (data.simulated) return {};  // of which nobody has published anything
  std::map<std::pair<double, std::string>, PublishedModel> models;
  const std::vector<ShareError>& groups = result.share_errors.groups;
  const SharesOfData measured = measured_shares(data);
  for (std::size_t g = 0; g < groups.size(); ++g) {
    const MeasuredRouting& routing = data.routings[groups[g].routing];
    const CatalogueEntry* entry = entry_of(catalogue, routing);
    if (!is_published(entry, routing, groups[g].grasp)) continue;
    const auto shares =
        std::find_if(measured.groups.begin(), measured.groups.end(), [&](const MeasuredShares& of) {
          return of.routing == groups[g].routing && of.grasp == groups[g].grasp;
        });
    if (shares == measured.groups.end()) continue;
    for (const PrintedList& list : printed_lists(*entry)) {
      if (list.kind != PrintedKind::share) continue;
      PublishedModel& model = models[{-list.hardware.tube.mu, place_of(list)}];
      model.mu = list.hardware.tube.mu;
      PublishedLine line{g, list.source, {}, 0, 0};
      for (const PrintedNumber& number : list.numbers) line.shares.push_back(number.value / 100);
      const std::vector<double> equations = solve(*entry, list.hardware).tension;
      line.error = distance_to_shares(shares->mean, line.shares);
      line.equations = share_distance(shares->mean, equations);
      add_losses(result, groups[g], *entry, line.shares, equations, model);
      model.lines.push_back(std::move(line));
    }
  }
  std::vector<PublishedModel> list;
  for (auto& [key, model] : models) {
    const std::string& first = model.lines.front().source;
    const std::string& last = model.lines.back().source;
    model.name = first;
    if (last != first) model.name += " to " + last;
    for (const PublishedLine& line : model.lines) {
      model.error += line.error / static_cast<double>(model.lines.size());
      model.equations += line.equations / static_cast<double>(model.lines.size());
    }
    list.push_back(std::move(model));
  }
  return list;
}

}  // namespace reeve
