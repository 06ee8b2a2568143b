#include "diagnosis/verdict/losses.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <tuple>

#include "numerics/robust.hpp"

namespace reeve::diagnosis {
namespace {

constexpr double greatest_score = 3.5;
// Losses that agree better than that agree by their rounding, as those of made-up data may.
constexpr double least_scatter = 1e-3;
constexpr double sure_of_noise = 2;
constexpr double least_noise = 1e-9;           // relative: readings without any weigh alike
constexpr double normal_consistency = 0.6745;  // MAD of a normal distribution over its deviation

// Two measured segments with nothing measured between them.
struct MeasuredStretch {
  const TendonSpan* tendon = nullptr;
  std::size_t left = 0;  // segments of the network, in walk order
  std::size_t right = 0;
  std::vector<std::size_t> contacts;  // from left to right
};

std::vector<MeasuredStretch> stretches(const Network& network, const std::vector<bool>& measured) {
  std::vector<MeasuredStretch> result;
  for (const TendonSpan& tendon : network.tendons) {
    for (std::size_t k = 0; k < tendon.segments; ++k) {
      if (!measured[tendon.first_segment + k]) continue;
      MeasuredStretch stretch{&tendon, tendon.first_segment + k, tendon.first_segment + k, {}};
      for (std::size_t c = k; c < k + tendon.contacts; ++c) {
        const std::size_t at = c % tendon.segments;
        if (at >= tendon.contacts) break;  // the end of an open tendon
        stretch.contacts.push_back(tendon.first_contact + at);
        stretch.right = ends_of(tendon, at).right;
        if (measured[stretch.right]) break;
      }
      if (measured[stretch.right] && stretch.right != stretch.left) result.push_back(stretch);
    }
  }
  return result;
}

// Rows of one routing in one grasp and direction.
using GroupKey = std::tuple<std::size_t, std::uint64_t, Direction>;
using Row = std::map<std::size_t, const ComparedCell*>;  // by segment

std::vector<std::pair<GroupKey, std::vector<Row>>> groups(const MeasuredData& data,
                                                          const std::vector<ComparedCell>& cells) {
  std::vector<std::pair<GroupKey, std::vector<Row>>> result;
  std::optional<std::size_t> reading;
  Row* row = nullptr;
  for (const ComparedCell& cell : cells) {
    if (reading != cell.cell.reading) {
      reading = cell.cell.reading;
      const Reading& about = data.readings[*reading];
      const GroupKey key{about.routing, about.grasp.held, about.direction};
      auto found =
          std::ranges::find_if(result, [&](const auto& group) { return group.first == key; });
      if (found == result.end()) found = result.insert(found, {key, {}});
      row = &found->second.emplace_back();
    }
    row->emplace(cell.cell.segment, &cell);
  }
  return result;
}

// +1: the tension falls from left to right by all the friction there is; -1: from right to left;
// 0: some contact holds with less, or they work against each other.
int fall(const Network& network, const MeasuredStretch& stretch, const Mechanics& mechanics,
         const TensionState& state) {
  constexpr double used_up = 1 - 1e-6;
  int result = 0;
  for (const std::size_t contact : stretch.contacts) {
    const auto [left, right] = ends_of(*stretch.tendon, contact - stretch.tendon->first_contact);
    const double drop = std::log(state.tension[left] / state.tension[right]);
    const double most = sliding_exponent(network, mechanics, contact, state);
    if (!(std::abs(drop) >= used_up * most) || drop == 0) return 0;
    const int direction = drop > 0 ? 1 : -1;
    if (result != 0 && direction != result) return 0;
    result = direction;
  }
  return result;
}

class LossTable {
 public:
  LossTable(const MeasuredData& data, const Model& model) : data_(data), model_(model) {}

  void add(const GroupKey& key, const std::vector<Row>& rows) {
    const auto& [routing, held, direction] = key;
    const MeasuredRouting& about = data_.routings[routing];
    const Network& network = about.network;
    // Behind a seized contact the friction of the others does not add up from the motor on.
    if (!seized_contacts(model_, about.word, network).empty()) return;
    const Mechanics mechanics = core::mechanics(network, effective_hardware(model_));
    const Grasp recorded{held};
    const TensionState state =
        tensions(network, mechanics, actual_grasp(model_, about.word, recorded), direction);
    std::vector<bool> measured(network.segments.size(), false);
    for (const Row& row : rows) {
      for (const auto& [segment, cell] : row) measured[segment] = true;
    }
    for (const MeasuredStretch& stretch : stretches(network, measured)) {
      const int way = fall(network, stretch, mechanics, state);
      if (way == 0) continue;
      const std::size_t high = way > 0 ? stretch.left : stretch.right;
      const std::size_t low = way > 0 ? stretch.right : stretch.left;
      Loss loss;
      loss.routing = routing;
      loss.grasp = recorded;
      loss.direction = direction;
      loss.high = network.segments[high];
      loss.low = network.segments[low];
      for (const std::size_t c : stretch.contacts) loss.over.push_back(network.contacts[c].kind);
      if (way < 0) std::ranges::reverse(loss.over);
      for (const Row& row : rows) add_row(row, high, low, loss);
      if (loss.rows > 0) result_.push_back(mean(loss));
    }
  }

  std::vector<Loss> take() && { return std::move(result_); }

 private:
  // By the forecast: chosen by what they read, readings near zero would be those that read too
  // much.
  static bool is_taut(const ComparedCell& cell) {
    constexpr double sure = 3;  // deviations; the logarithm of less is mostly noise
    return cell.cell.measured_N > 0 && cell.before_N > 0 && cell.after_N > sure * cell.deviation_N;
  }

  // By their noise: the logarithm of a noisy reading is too small on average.
  static void add_row(const Row& row, std::size_t high, std::size_t low, Loss& loss) {
    const auto from = row.find(high);
    const auto to = row.find(low);
    if (from == row.end() || to == row.end()) return;
    const ComparedCell& a = *from->second;
    const ComparedCell& b = *to->second;
    if (!is_taut(a) || !is_taut(b)) return;
    const double weight = 1 / (std::pow(std::max(a.deviation_N / a.after_N, least_noise), 2) +
                               std::pow(std::max(b.deviation_N / b.after_N, least_noise), 2));
    ++loss.rows;
    loss.deviation += weight;
    loss.measured += weight * std::log(a.cell.measured_N / b.cell.measured_N);
    loss.before += weight * std::log(a.before_N / b.before_N);
    loss.after += weight * std::log(a.after_N / b.after_N);
  }

  static Loss mean(Loss loss) {
    const double weight = loss.deviation;
    loss.measured /= weight;
    loss.deviation = 1 / std::sqrt(weight);
    loss.before /= weight;
    loss.after /= weight;
    return loss;
  }

  const MeasuredData& data_;
  const Model& model_;
  std::vector<Loss> result_;
};

// |0.6745 (x − median) / MAD| of each.
std::vector<double> scores(std::vector<double> values, double least) {
  const double middle = median(values);
  for (double& value : values) value = std::abs(value - middle);
  const double typical = std::max(least, median(values));
  for (double& value : values) value *= normal_consistency / typical;
  return values;
}

// Marks the stretches over the same contacts that stand apart.
void mark_those_apart(const std::vector<Loss*>& alike) {
  if (alike.size() < enough_stretches) return;
  std::vector<double> left;
  for (const Loss* loss : alike) left.push_back(loss->measured - loss->after);
  const double middle = median(left);
  std::vector<double> in_noise;
  for (std::size_t i = 0; i < alike.size(); ++i) {
    in_noise.push_back((left[i] - middle) / std::max(alike[i]->deviation, least_scatter));
  }
  const std::vector<double> score = scores(left, least_scatter);
  const std::vector<double> score_in_noise = scores(in_noise, least_scatter);
  for (std::size_t i = 0; i < alike.size(); ++i) {
    alike[i]->stands_apart = score[i] > greatest_score && score_in_noise[i] > greatest_score &&
                             std::abs(in_noise[i]) > sure_of_noise;
  }
}

}  // namespace

std::vector<Loss> losses(const MeasuredData& data, const Model& extended,
                         const std::vector<ComparedCell>& cells) {
  LossTable table(data, extended);
  for (const auto& [key, rows] : groups(data, cells)) table.add(key, rows);
  std::vector<Loss> result = std::move(table).take();
  std::map<std::vector<ContactKind>, std::vector<Loss*>> by_contacts;
  for (Loss& loss : result) by_contacts[loss.over].push_back(&loss);
  for (const auto& [over, alike] : by_contacts) mark_those_apart(alike);
  return result;
}

}  // namespace reeve::diagnosis
