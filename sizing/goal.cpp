#include "sizing/goal.hpp"

#include <fmt/format.h>

#include <optional>

#include "core/error.hpp"
#include "core/text.hpp"

namespace reeve::sizing {
namespace {

constexpr double least_pull = 1e-3;
constexpr double greatest_pull = 1e3;

std::vector<std::string> factors_in(const std::string& text) {
  std::vector<std::string> factors{""};
  for (const char c : text) {
    if (c == '*') {
      factors.emplace_back();
    } else {
      factors.back() += c;
    }
  }
  return factors;
}

class TargetReader {
 public:
  TargetReader(const std::string& text, int fingers)
      : text_(text), pulls_(static_cast<std::size_t>(fingers)) {}

  std::vector<double> read() {
    for (const std::string& item : comma_separated(text_)) read(item);
    double sum = 0;
    std::vector<double> shares;
    for (const auto& pull : pulls_) {
      const std::optional<double> here = pull ? pull : others_;
      if (!here) fail();
      shares.push_back(*here);
      sum += *here;
    }
    for (double& share : shares) share /= sum;
    return shares;
  }

 private:
  [[noreturn]] void fail() const {
    throw InputError(
        {.what = "target",
         .value = text_,
         .expected = fmt::format("a pull from {} to {} for each of the {} fingers once, such as {}",
                                 least_pull, greatest_pull, pulls_.size(), "1=2,others=1")});
  }

  void read(const std::string& item) {
    const std::size_t equals = item.find('=');
    if (equals == std::string::npos) fail();
    const auto pull = number_in(trimmed(std::string_view(item).substr(equals + 1)));
    if (!pull || *pull < least_pull || *pull > greatest_pull) fail();
    const std::string_view name = trimmed(std::string_view(item).substr(0, equals));
    std::optional<double>& place = name == "others" ? others_ : pull_of(name);
    if (place) fail();
    place = pull;
  }

  std::optional<double>& pull_of(std::string_view finger) {
    const auto number = whole_number_in(finger);
    if (!number || *number < 1 || *number > static_cast<int>(pulls_.size())) fail();
    return pulls_[static_cast<std::size_t>(*number) - 1];
  }

  const std::string& text_;
  std::vector<std::optional<double>> pulls_;
  std::optional<double> others_;
};

}  // namespace

Better Goal::better() const {
  if (is_target()) return Better::lower;
  return factors.size() > 1 ? Better::higher : row(factors.front()).better;
}

Goal parse_goal(const std::string& text) {
  const std::string option = fmt::format("goal '{}'", text);
  Goal goal;
  for (const std::string& item : factors_in(text)) {
    const std::string name(trimmed(item));
    const ObjectiveRow& about = row(parse_objective(name, option));
    if (about.is_count()) {
      throw InputError({.where = option,
                        .what = fmt::format("'{}' is a count, which no dimension changes", name)});
    }
    goal.factors.push_back(about.objective);
  }
  for (const Objective factor : goal.factors) {
    if (goal.factors.size() == 1 || row(factor).better == Better::higher) continue;
    throw InputError({.where = option,
                      .what = fmt::format("of '{}' lower is better", row(factor).name),
                      .expected = "objectives of which higher is better in a product",
                      .form = InputForm::unknown});
  }
  return goal;
}

Goal parse_target(const std::string& text, int fingers) {
  return {{}, TargetReader(text, fingers).read()};
}

std::string to_text(const Goal& goal) {
  std::string text;
  for (const Objective factor : goal.factors) {
    text += (text.empty() ? "" : " x ") + std::string(row(factor).name);
  }
  for (const double share : goal.target)
    text += fmt::format("{}{:.4g}", text.empty() ? "" : ", ", share);
  return goal.is_target() ? "target shares " + text : text;
}

}  // namespace reeve::sizing
