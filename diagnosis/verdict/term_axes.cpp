#include "diagnosis/verdict/term_axes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <string_view>
#include <utility>

namespace reeve::diagnosis {
namespace {

using causes::Covariate;
using causes::CovariateKind;
using causes::Form;
using causes::Site;
using causes::SitePlace;
using causes::Target;
using causes::Term;

constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

AxisName covariate_axis(const Covariate& covariate) {
  switch (covariate.kind) {
    case CovariateKind::load:
      return {"load", "N"};
    case CovariateKind::tension:
      return {"tension at " + causes::covariate_name(covariate), "N"};
    case CovariateKind::motor:
      return {"motor tension", "N"};
    case CovariateKind::speed:
      return {"speed", "mm/s"};
    case CovariateKind::cycle:
      return {"cycle", "1"};
    case CovariateKind::temperature:
      return {"temperature", "°C"};
    case CovariateKind::column:
      if (covariate.column == "sheath_angle_rad") return {"sheath angle", "rad"};
      if (covariate.column == "order") return {"place in the file, first 0, last 1", "1"};
      if (covariate.column == "run") return {"number of the run", "1"};
      if (covariate.column == "row_in_run") return {"place in the run, from 1", "1"};
      if (covariate.column == "since_pause_s") return {"time since the last pause", "s"};
      break;
    case CovariateKind::none:
      break;
  }
  return {covariate.column, ""};
}

// "ln(speed / 10)", "(temperature - 22)"
std::string factor_text(const Covariate& covariate) {
  const std::string name = covariate_axis(covariate).name;
  return covariate.logarithmic ? fmt::format("ln({} / {:.4g})", name, covariate.middle)
                               : fmt::format("({} - {:.4g})", name, covariate.middle);
}

AxisName law_axis(Target target, const Site& site) {
  switch (target) {
    case Target::exponent:
      return {causes::is_tube_or_sheath(site.kind) ? "relative change of the friction exponent"
                                                   : "change of the friction exponent",
              "1"};
    case Target::force:
      return {"further force", "N"};
    case Target::gain:
      return {"relative change of the gain", "1"};
    case Target::offset:
      return {"offset", "N"};
  }
  return {};
}

AxisName size_axis(const Parameter& parameter, double nominal) {
  const std::string name = parameter.name;
  const bool has_unit = name.ends_with(std::string("_") + parameter.unit);
  const std::string text =
      has_unit ? name.substr(0, name.size() - std::string_view(parameter.unit).size() - 1) : name;
  return {nominal == 0 ? text : fmt::format("{} - {:.4g}", text, nominal), parameter.unit};
}

void follow_load_or_motor(TermAxes& axes, bool has_motor_tension) {
  if (axes.is_of_sensors()) {
    axes.over = DrawnOver::sensor;
    axes.x = {"tension at the sensor", "N"};
  } else if (axes.sites.front().place == SitePlace::contacts) {
    axes.over = DrawnOver::contacts;
    axes.x = {"load at the contacts", "N"};
  } else if (has_motor_tension) {
    axes.covariate.kind = CovariateKind::motor;
    axes.x = covariate_axis(axes.covariate);
  } else {
    axes.over = DrawnOver::row;
    axes.x = {"sum of the readings", "N"};
  }
}

void add_lever(TermAxes& axes, Target target) {
  for (const Site& site : axes.sites) axes.levers.push_back({.target = target, .site = site});
}

// True if a factor is applied to the exponent or gain that the law has left.
bool is_factor(Target target, const Site& site) {
  return target == Target::gain ||
         (target == Target::exponent && causes::is_tube_or_sheath(site.kind));
}

void follow(TermAxes& axes, const Covariate& covariate) {
  axes.covariate = covariate;
  if (covariate.kind == CovariateKind::load) {
    follow_load_or_motor(axes, true);
    return;
  }
  axes.over = covariate.kind == CovariateKind::tension ? DrawnOver::other : DrawnOver::recorded;
  axes.x = covariate_axis(covariate);
}

TermAxes axes_of_law(const Term& term, bool has_motor_tension) {
  TermAxes axes;
  axes.sites = {term.site};
  axes.y = law_axis(term.target, term.site);
  add_lever(axes, term.target);
  axes.multiplies = is_factor(term.target, term.site);
  if (term.form == Form::constant) {
    follow_load_or_motor(axes, has_motor_tension);
    axes.law = [](const std::vector<double>& values, double) { return values[0]; };
  } else if (term.form == Form::product) {
    axes.over = DrawnOver::product;
    axes.product = term;
    axes.x = {factor_text(term.x) + " x " + factor_text(term.y), "1"};
    axes.law = [](const std::vector<double>& values, double x) { return values[0] * x; };
  } else {
    follow(axes, term.x);
    axes.law = [term](const std::vector<double>& values, double x) {
      return causes::law_value(term, x, term.y.middle, values.data());
    };
  }
  return axes;
}

Conditions conditions_at(const Covariate& covariate, double x) {
  Conditions conditions;
  if (covariate.kind == CovariateKind::speed) conditions.speed_mm_s = x;
  if (covariate.kind == CovariateKind::cycle) conditions.cycle = x;
  if (covariate.kind == CovariateKind::temperature) conditions.temperature_C = x;
  return conditions;
}

// The cause is classed by what it makes of an exponent of 1.
std::function<double(const std::vector<double>&, double)> exponent_law(const Effect& effect,
                                                                       const Covariate& covariate) {
  return [effect, covariate](const std::vector<double>& values, double x) {
    ContactLoad contact;
    if (covariate.kind == CovariateKind::load) contact.high_N = x;
    const Effect at{effect.cause, effect.subject, values};
    return effect.cause->exponent(1, contact, conditions_at(covariate, x), at) - 1;
  };
}

// The same for all readings, whatever its size: its parameter less the nominal value.
void measure_size(TermAxes& axes, const Effect& effect, const Hardware& hardware) {
  const Parameter parameter = effect.cause->parameters(hardware).front();
  const double nominal = parameter.nominal.value_or(0);
  axes.y = size_axis(parameter, nominal);
  axes.law = [nominal](const std::vector<double>& values, double) { return values[0] - nominal; };
}

// Of a cause that acts at the contacts of these sites.
TermAxes axes_at_contacts(std::vector<Site> sites, const Effect& effect, const Hardware& hardware) {
  TermAxes axes;
  axes.sites = std::move(sites);
  const std::string follows = effect.cause->follows();
  if (follows.empty()) {
    measure_size(axes, effect, hardware);
    follow_load_or_motor(axes, true);
    return axes;
  }
  follow(axes, causes::covariate_named(follows));
  // The loss is the same at every angle, which tells it from the coefficient.
  if (effect.cause->name() == std::string_view("wrap_free_loss")) {
    measure_size(axes, effect, hardware);
    return axes;
  }
  add_lever(axes, Target::exponent);
  axes.y = law_axis(Target::exponent, axes.sites.front());
  axes.multiplies = true;
  axes.law = exponent_law(effect, axes.covariate);
  return axes;
}

// The sensor's reading follows something else than a constant gain or offset.
void measure_offset(TermAxes& axes, const Effect& effect) {
  const std::string_view name = effect.cause->name();
  axes.y = law_axis(Target::offset, axes.sites.front());
  add_lever(axes, Target::offset);
  if (name == "saturation" || name == "dead_zone") {
    follow_load_or_motor(axes, true);
    axes.law = [effect](const std::vector<double>& values, double x) {
      const Effect at{effect.cause, effect.subject, values};
      return effect.cause->reading(x, *effect.subject.channel, at) - x;
    };
    return;
  }
  axes.law = [](const std::vector<double>& values, double x) { return values[0] * x; };
  if (name == "drift") {
    follow(axes, causes::covariate_named(effect.cause->follows()));
  } else {
    axes.over = DrawnOver::beside;
    axes.x = {"sum of the tensions beside it", "N"};
  }
}

bool changes_the_offset(std::string_view name) {
  return name == "saturation" || name == "dead_zone" || name == "drift" || name == "cross_talk";
}

TermAxes axes_of_a_change() {
  TermAxes axes;
  axes.over = DrawnOver::change;
  axes.x = {"change of the forecast by it", "N"};
  axes.y = {"reading less the forecast without it", "N"};
  axes.sites = {{.place = SitePlace::motor}};
  axes.law = [](const std::vector<double>&, double x) { return x; };
  return axes;
}

double mean_of_contacts(const TermAxes& axes, const DrawnCell& cell,
                        const std::function<double(double load_N)>& value) {
  const DatasetRow& row = cell.dataset.rows[cell.row()];
  const MeasuredData& data = *cell.dataset.data;
  const Reading& reading = data.readings[row.reading];
  double sum = 0;
  double count = 0;
  for (const causes::SolvedContact& contact : cell.contacts[cell.row()]) {
    const ContactLoad load{contact.kind,
                           contact.high,
                           contact.number,
                           reading.direction,
                           contact.finger,
                           reading.grasp,
                           data.routings[reading.routing].word};
    const bool acts = std::ranges::any_of(
        axes.sites, [&](const Site& site) { return causes::acts_on(site, load); });
    if (!acts) continue;
    sum += value(contact.high);
    count += 1;
  }
  return count > 0 ? sum / count : unknown;
}

double forecast_at(const DrawnCell& cell, const std::function<bool(std::size_t channel)>& chosen) {
  const DatasetRow& row = cell.dataset.rows[cell.row()];
  double sum = 0;
  bool some = false;
  for (std::size_t i = row.first; i < row.last; ++i) {
    if (!chosen(cell.dataset.cells[i].channel)) continue;
    sum += cell.without.reading_N[static_cast<Eigen::Index>(i)];
    some = true;
  }
  return some ? sum : unknown;
}

double sum_of_readings(const DrawnCell& cell) {
  const DatasetRow& row = cell.dataset.rows[cell.row()];
  double sum = 0;
  for (std::size_t i = row.first; i < row.last; ++i) sum += cell.dataset.cells[i].measured_N;
  return sum;
}

}  // namespace

TermAxes term_axes(const Effect& effect, const Hardware& hardware, bool has_motor_tension) {
  if (const Term* term = causes::term_of(*effect.cause)) {
    return axes_of_law(*term, has_motor_tension);
  }
  if (effect.values.empty()) return axes_of_a_change();
  std::vector<Site> contacts;
  for (const ContactKind kind :
       {ContactKind::tube, ContactKind::sheath, ContactKind::bearing, ContactKind::block}) {
    if (!effect.cause->acts_at(kind)) continue;
    contacts.push_back({.kind = kind, .finger = effect.subject.finger});
  }
  if (!contacts.empty()) return axes_at_contacts(std::move(contacts), effect, hardware);
  const std::string_view name = effect.cause->name();
  TermAxes axes;
  axes.sites = {{.place = SitePlace::motor}};
  if (const auto& channel = effect.subject.channel) {
    axes.sites = {{.place = SitePlace::channel, .channel = *channel}};
  }
  if (changes_the_offset(name)) {
    measure_offset(axes, effect);
    return axes;
  }
  measure_size(axes, effect, hardware);
  if (name == "viscous_loss") {
    follow(axes, causes::covariate_named(effect.cause->follows()));
    add_lever(axes, Target::force);
    axes.y = law_axis(Target::force, axes.sites.front());
    axes.law = [](const std::vector<double>& values, double x) { return values[0] * x; };
  } else {
    follow_load_or_motor(axes, has_motor_tension);
  }
  return axes;
}

PlaceOnAxes place_on(const TermAxes& axes, const std::vector<double>& values,
                     const DrawnCell& cell) {
  const auto at = static_cast<Eigen::Index>(cell.cell);
  const DatasetRow& row = cell.dataset.rows[cell.row()];
  const auto law = [&](double x) { return PlaceOnAxes{x, axes.law(values, x)}; };
  const std::size_t own = cell.dataset.cells[cell.cell].channel;
  const std::vector<Channel>& channels = cell.dataset.data->channels;
  switch (axes.over) {
    case DrawnOver::contacts:
      return {mean_of_contacts(axes, cell, [](double load) { return load; }),
              mean_of_contacts(axes, cell, [&](double load) { return axes.law(values, load); })};
    case DrawnOver::sensor:
      return law(cell.without.reading_N[at]);
    case DrawnOver::other:
      return law(forecast_at(
          cell, [&](std::size_t c) { return channels[c].segment == axes.covariate.segment; }));
    case DrawnOver::beside:
      return law(forecast_at(cell, [&](std::size_t c) { return c + 1 == own || own + 1 == c; }));
    case DrawnOver::recorded:
      return law(causes::covariate_value(axes.covariate, row.conditions, unknown));
    case DrawnOver::product: {
      // The law of a = 1, at the mean of the loads where one of the factors is a load.
      const Term& term = axes.product;
      const auto factors = [&](double load) {
        const double one = 1;
        return causes::law_value(term, causes::covariate_value(term.x, row.conditions, load),
                                 causes::covariate_value(term.y, row.conditions, load), &one);
      };
      const bool at_contacts = term.site.place == SitePlace::contacts;
      return law(at_contacts ? mean_of_contacts(axes, cell, factors)
                             : factors(cell.without.reading_N[at]));
    }
    case DrawnOver::row:
      return law(sum_of_readings(cell));
    case DrawnOver::change:
      return law(cell.with.reading_N[at] - cell.without.reading_N[at]);
  }
  return {unknown, unknown};
}

}  // namespace reeve::diagnosis
