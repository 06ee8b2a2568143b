#include "reports/law_words.hpp"

#include <fmt/format.h>

namespace reeve::reports {
namespace {

// "tube friction of finger 1", "friction of tube 2 of M-1-F"
std::string friction_of(const Site& site) {
  std::string name = site_name(site);
  if (site.number) return "friction of " + name;
  const std::string kind = contact_kind_name(site.kind);
  return kind + " friction" + name.substr(kind.size());
}

std::string subject(const Term& term) {
  const Site& site = term.site;
  std::string name = site_name(site);
  const bool at_motor = site.place == SitePlace::motor;
  switch (term.target) {
    case Target::exponent:
      return friction_of(site);
    case Target::force:
      if (at_motor) return "the force lost between " + name + " and tendon";
      return fmt::format("the force that {}{} takes", site.number ? "" : "each ", name);
    case Target::gain:
      return fmt::format("the gain of {}{}", at_motor ? "the " : "", name);
    case Target::offset:
      return fmt::format("the offset of {}{}", at_motor ? "the " : "", name);
  }
  return name;
}

std::string covariate_words(const Covariate& covariate) {
  if (covariate.kind == CovariateKind::load) return "the load";
  if (covariate.kind == CovariateKind::tension)
    return "the tension at " + covariate_name(covariate);
  if (covariate.column == "since_pause_s") return "the time since the last pause";
  return covariate_name(covariate);
}

struct Change {
  double rise = 0;  // by how much it rises in all, going up the range
  double fall = 0;
};

Change change_over_range(const Term& term, const std::vector<double>& values) {
  constexpr int steps = 256;
  const auto [low, high] = term.x.seen;
  Change change;
  double before = law_value(term, low, term.y.middle, values.data());
  for (int i = 1; i <= steps; ++i) {
    const double x = low + (high - low) * i / steps;
    const double here = law_value(term, x, term.y.middle, values.data());
    (here > before ? change.rise : change.fall) += std::abs(here - before);
    before = here;
  }
  return change;
}

std::string verb(const Term& term, const std::vector<double>& values) {
  constexpr double hardly = 0.1;  // share of the whole change
  const Change change = change_over_range(term, values);
  if (change.fall <= hardly * change.rise) return "grows with";
  if (change.rise <= hardly * change.fall) return "falls with";
  return "rises and falls with";
}

const char* greater_or_smaller(double difference) { return difference < 0 ? "smaller" : "greater"; }

// A list of two in a product.
template <typename Part>
Json parts(const Term& term, Part part) {
  if (term.form == Form::constant) return nullptr;
  if (term.form == Form::product) return Json::array({part(term.x), part(term.y)});
  return part(term.x);
}

std::string covariate_unit(const Covariate& covariate) {
  switch (covariate.kind) {
    case CovariateKind::load:
    case CovariateKind::tension:
    case CovariateKind::motor:
      return "N";
    case CovariateKind::speed:
      return "mm/s";
    case CovariateKind::temperature:
      return "C";
    case CovariateKind::column:
      return covariate.column;
    default:
      return "1";
  }
}

// "N/(mm/s)"; a factor without unit divides by nothing.
std::string over(const std::string& unit, const std::string& by) {
  if (by == "1") return unit;
  return unit + "/" + (by.find_first_of("/ ") == std::string::npos ? by : "(" + by + ")");
}

}  // namespace

std::string law_meaning(const Term& term, const std::vector<double>& values) {
  const std::string about = subject(term);
  const std::string x = covariate_words(term.x);
  switch (term.form) {
    case Form::constant:
      return fmt::format("{} is {} than in {}", about, greater_or_smaller(values[0]),
                         term.site.group.empty() ? "the nominal model" : "other groups");
    case Form::step:
      return fmt::format("{} is {} where {} is above {:.4g}", about, greater_or_smaller(values[0]),
                         x, values[1]);
    case Form::hinge:
      return fmt::format("{} {} {} above {:.4g}", about,
                         values[0] < 0 ? "falls with" : "grows with", x, values[1]);
    case Form::product:
      return fmt::format("{} depends on {} and {} together", about, x, covariate_words(term.y));
    default:
      return fmt::format("{} {} {}", about, verb(term, values), x);
  }
}

std::string law_unit(const Term& term, std::size_t parameter) {
  const bool is_force = term.target == Target::force || term.target == Target::offset;
  std::string unit = is_force ? "N" : "1";
  const std::string x = covariate_unit(term.x);
  const bool is_size = parameter == 0;
  switch (term.form) {
    case Form::linear:
      return over(unit, x);
    case Form::power:
    case Form::scaling:
      return is_size ? unit : "1";
    case Form::quadratic:
      return is_size ? over(over(unit, x), x) : x;
    case Form::hinge:
      return is_size ? over(unit, x) : x;
    case Form::exponential:
    case Form::step:
      return is_size ? unit : x;
    case Form::sine:
      return parameter < 2 ? unit : x;
    case Form::product: {
      const std::string of_x = term.x.logarithmic ? unit : over(unit, x);
      return term.y.logarithmic ? of_x : over(of_x, covariate_unit(term.y));
    }
    default:
      return unit;
  }
}

Json law_json(const Term& term) {
  const auto name = [](const Covariate& x) { return Json(covariate_name(x)); };
  const auto middle = [](const Covariate& x) { return number(x.middle); };
  const auto range = [](const Covariate& x) {
    return Json::array({number(x.seen.low), number(x.seen.high)});
  };
  Json json{{"site", site_name(term.site)},
            {"acts_on", target_name(term.target)},
            {"covariate", term.form == Form::product
                              ? Json(covariate_name(term.x) + " x " + covariate_name(term.y))
                              : parts(term, name)},
            {"form", form_name(term.form)},
            {"middle", parts(term, middle)},
            {"range", parts(term, range)}};
  if (term.form == Form::product) {
    json["logarithmic"] = Json::array({term.x.logarithmic, term.y.logarithmic});
  }
  return json;
}

std::string law_text(const Term& term, const std::vector<double>& values) {
  return site_name(term.site) + ": " + formula(term, values);
}

}  // namespace reeve::reports
