#include "core/nearest_name.hpp"

#include <algorithm>
#include <cctype>

namespace reeve::core {
namespace {

// No name has as many; the table of distances grows with the product of two lengths.
constexpr std::size_t longest_word = 64;

constexpr std::size_t shortest_start = 2;
constexpr std::size_t most_alike = 2;

std::string in_lower_case(std::string_view text) {
  std::string lower(text);
  for (char& letter : lower) {
    letter = static_cast<char>(std::tolower(static_cast<unsigned char>(letter)));
  }
  return lower;
}

std::size_t distance_to(const std::string& word, const std::string& name) {
  if (word.size() >= shortest_start && name.starts_with(word)) return 0;
  return edit_distance(word, name);
}

}  // namespace

std::size_t edit_distance(std::string_view a, std::string_view b) {
  std::vector<std::vector<std::size_t>> cost(a.size() + 1, std::vector<std::size_t>(b.size() + 1));
  for (std::size_t i = 0; i <= a.size(); ++i) cost[i][0] = i;
  for (std::size_t j = 0; j <= b.size(); ++j) cost[0][j] = j;
  for (std::size_t i = 1; i <= a.size(); ++i) {
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t replaced = cost[i - 1][j - 1] + (a[i - 1] == b[j - 1] ? 0U : 1U);
      cost[i][j] = std::min({cost[i - 1][j] + 1, cost[i][j - 1] + 1, replaced});
      const bool exchanged = i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1];
      if (exchanged) cost[i][j] = std::min(cost[i][j], cost[i - 2][j - 2] + 1);
    }
  }
  return cost[a.size()][b.size()];
}

std::optional<std::string> nearest_name(std::string_view word,
                                        const std::vector<std::string>& known) {
  if (word.empty() || word.size() > longest_word) return std::nullopt;
  const std::string typed = in_lower_case(word);
  std::size_t least = typed.size() / 3;
  std::vector<std::string> nearest;
  for (const std::string& name : known) {
    const std::size_t distance = distance_to(typed, in_lower_case(name));
    if (distance > least) continue;
    if (distance < least) nearest.clear();
    least = distance;
    nearest.push_back(name);
  }
  if (nearest.empty() || nearest.size() > most_alike) return std::nullopt;
  return nearest.front();
}

std::string did_you_mean(std::string_view word, const std::vector<std::string>& known) {
  const auto nearest = nearest_name(word, known);
  return nearest ? "; did you mean " + *nearest + "?" : "";
}

}  // namespace reeve::core
