#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>

#include "drawing/chart/chart.hpp"
#include "pages/diagnosis/diagnosis_figures.hpp"
#include "pages/diagnosis/diagnosis_labels.hpp"
#include "reports/diagnosis/diagnosis_words.hpp"

namespace reeve::pages {
namespace {

constexpr std::size_t most_models = 15;

// Shapes and colours keep their meaning, whichever of them a diagnosis has.
struct StandingStyle {
  const char* standing;
  chart::Style style;
};

const std::array<StandingStyle, 4> standing_styles{
    {{"weighed", {chart::Colour::blue, chart::Symbol::circle, 5.5}},
     {"named", {chart::Colour::orange, chart::Symbol::diamond, 5.5}},
     {"cannot be told from it", {chart::Colour::green, chart::Symbol::square, 5.5}},
     {"not confirmed", {chart::Colour::pink, chart::Symbol::cross, 5.5}}}};

std::string title(const WeighedCauses& weighed, const std::string& place) {
  std::string text = fmt::format("{}: {}\nall readings: {}", joined_causes(weighed.causes), place,
                                 gain_number(weighed.gain));
  if (weighed.held_out) {
    text +=
        fmt::format("\nheld-out runs: {} ({})", gain_number(weighed.held_out->log_likelihood_gain),
                    gain_interval(weighed.held_out->gain_low, weighed.held_out->gain_high));
  }
  return text;
}

// A line for what the noise allows, and the band in which noise puts it.
void add_noise_limit(const NoiseLimit& limit, chart::Panel& panel) {
  chart::Style grey{chart::Colour::grey};
  grey.fill = 0.2;
  chart::Style dashed{chart::Colour::ink};
  dashed.dash = chart::Dash::dashed;
  panel.layers.push_back({"where noise puts that, 95 %", grey,
                          chart::PanelBands{{{0, limit.low, limit.high, ""}}, chart::Along::x}});
  panel.layers.push_back({"as good as noise allows", dashed,
                          chart::Rules{{{limit.log_likelihood_gain, "as good as noise allows", ""}},
                                       chart::Along::x}});
}

// The best on the training runs, the named one among them even where others gain more.
std::vector<WeighedCauses> drawn_models(const DiagnosisResult& result) {
  std::vector<WeighedCauses> models = by_training_gain(result.weighed);
  if (models.size() <= most_models) return models;
  const auto named = std::ranges::find_if(models, [&](const WeighedCauses& model) {
    return standing(result, model.causes) == "named";
  });
  const auto last = models.begin() + most_models - 1;
  if (named != models.end() && named > last) std::iter_swap(named, last);
  models.resize(most_models);
  return models;
}

// The intervals of all, and the points of each standing.
void add_models(const DiagnosisResult& result, chart::Panel& panel) {
  const std::vector<WeighedCauses> models = drawn_models(result);
  std::array<chart::Points, standing_styles.size()> points;
  chart::Spans intervals{{}, chart::Along::x, {}};
  for (std::size_t i = 0; i < models.size(); ++i) {
    const WeighedCauses& weighed = models[i];
    const std::string place = standing(result, weighed.causes);
    const std::string text = title(weighed, place);
    const auto at = static_cast<double>(i);
    panel.y.categories.push_back((place == "named" ? "◆ " : "") + joined_causes(weighed.causes));
    // One without tensions in some held-out row has no place on an axis of held-out runs.
    if (result.noise_limit && !weighed.held_out) continue;
    const double gain = weighed.held_out ? weighed.held_out->log_likelihood_gain : weighed.gain;
    if (weighed.held_out) {
      intervals.spans.push_back(
          {at, weighed.held_out->gain_low, weighed.held_out->gain_high, text});
    }
    for (std::size_t k = 0; k < standing_styles.size(); ++k) {
      if (standing_styles[k].standing == place) points[k].spots.push_back({gain, at, text, ""});
    }
  }
  chart::Style ink{chart::Colour::ink};
  ink.line = 2;
  panel.layers.push_back({"", ink, intervals});
  for (std::size_t k = 0; k < standing_styles.size(); ++k) {
    if (points[k].spots.empty()) continue;
    panel.layers.push_back({standing_styles[k].standing, standing_styles[k].style, points[k]});
  }
}

// A line for each cause of a model: names of several are too long for one.
double model_row_px(const std::vector<WeighedCauses>& weighed) {
  constexpr double line_px = 15;
  std::size_t most = 0;
  for (const WeighedCauses& model : weighed) most = std::max(most, model.causes.size());
  return std::max(row_px, line_px * static_cast<double>(most) + 6);
}

std::string drawn_text(const DiagnosisResult& result) {
  if (result.weighed.size() <= most_models) return "";
  return fmt::format(
      " Drawn are the named model and the likeliest others, {} of {}; the table has "
      "all.",
      most_models, result.weighed.size());
}

std::string weighed_caption(const DiagnosisReport& report) {
  const DiagnosisResult& result = report.result;
  std::string text = simulated_label(report);
  if (!result.noise_limit) {
    return text +
           "Gain on the runs that the models were fitted to, since none were held out: "
           "more parameters always gain something there." +
           drawn_text(result);
  }
  text +=
      "Held-out runs are forecast by models that have not seen them. Bars: 95 % intervals over weighed "
      "held-out ";
  text += result.held_out_runs < 5 ? "readings." : "runs.";
  text +=
      " The dashed line is what a model gains on average that leaves nothing but noise, the grey "
      "band where noise puts it in 95 % of data sets.";
  text += drawn_text(result);
  const std::vector<WeighedCauses> drawn = drawn_models(result);
  if (std::ranges::any_of(drawn, [](const WeighedCauses& model) { return !model.held_out; })) {
    text += " A row without a mark: that model has no tensions in some held-out reading.";
  }
  return text;
}

}  // namespace

Figure weighed_figure(const DiagnosisReport& report) {
  const DiagnosisResult& result = report.result;
  chart::Panel panel;
  panel.x.title = fmt::format("gain in log-likelihood on {} runs",
                              result.noise_limit ? "held-out" : "training");
  if (result.noise_limit) add_noise_limit(*result.noise_limit, panel);
  const chart::Style ink{chart::Colour::ink};
  panel.layers.push_back({"", ink, chart::Rules{{{0, "the nominal model", ""}}, chart::Along::x}});
  add_models(result, panel);
  const std::vector<std::string>& names = panel.y.categories;
  chart::Chart chart;
  chart.alt = fmt::format(
      "Gain in log-likelihood of {} models, best {}; the table below has the "
      "numbers.",
      names.size(), names.empty() ? "none" : names.front());
  chart.width = 280;
  chart.height = model_row_px(result.weighed) * static_cast<double>(names.size());
  chart.panels.push_back(std::move(panel));
  return {"weighed", "The causes, weighed.", weighed_caption(report), chart_svg(chart)};
}

}  // namespace reeve::pages
