#include "causes/term.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <memory>
#include <mutex>
#include <numbers>
#include <utility>

namespace reeve::causes {
namespace {

double factor(const Covariate& covariate, double x, double middle) {
  x = std::clamp(x, covariate.seen.low, covariate.seen.high);
  return covariate.logarithmic ? std::log(x / middle) : x - middle;
}
double reach_of(Covariate x, bool is_logarithmic) {
  x.logarithmic = is_logarithmic;
  return std::max(std::abs(factor(x, x.seen.low, x.middle)),
                  std::abs(factor(x, x.seen.high, x.middle)));
}

// The greatest |f| for a = 1, so that the range of a is that of what it does.
double reach_of(const Term& term) {
  const double span = term.x.seen.high - term.x.seen.low;
  switch (term.form) {
    case Form::linear:
    case Form::log:
      return reach_of(term.x, term.form == Form::log);
    case Form::quadratic:
      return std::pow(span, 2) / 4;
    case Form::hinge:
      return span / 2;
    case Form::product:
      return reach_of(term.x, term.x.logarithmic) * reach_of(term.y, term.y.logarithmic);
    default:
      return 1;
  }
}

Parameter shape_parameter(const Term& term) {
  const auto [low, high] = term.x.seen;
  const double span = high - low;
  switch (term.form) {
    case Form::power:
      return {"b", "1", std::nullopt, {-3, 3}, std::nullopt};
    case Form::scaling:
      return {"b", "1", std::nullopt, {0.1, 3}, std::nullopt};
    case Form::exponential:
      return {"b", "", std::nullopt, {0.02 * high, 5 * high}, std::nullopt};
    case Form::quadratic:
      return {"b", "", std::nullopt, {low - span, high + span}, std::nullopt};
    default:  // hinge, step
      return {"b", "", std::nullopt, {low, high}, std::nullopt};
  }
}

// Returns the range of f that is searched. An exponent that f would make negative is 0.
Range size_range(const Term& term) {
  switch (term.target) {
    case Target::exponent:
      return is_tube_or_sheath(term.site.kind) ? Range{-2, 5} : Range{-0.5, 2};
    case Target::force:
      return {-10, 10};
    case Target::gain:
      return {-0.9, 2};
    case Target::offset:
      return {-40, 40};
  }
  return {};
}

std::vector<Parameter> parameters_of(const Term& term) {
  const bool is_force = term.target == Target::force || term.target == Target::offset;
  const double reach = std::max(reach_of(term), 1e-12);
  const Range most = size_range(term);
  const char* unit = is_force ? "N" : "1";
  const Range either{std::min(most.low, -most.high) / reach,
                     std::max(most.high, -most.low) / reach};
  std::vector<Parameter> parameters{{"a", unit, 0, either, std::nullopt}};
  switch (term.form) {
    case Form::power:
    case Form::scaling:
      parameters.front() = {"a", unit, 0, is_force ? most : Range{-3, 3}, std::nullopt};
      [[fallthrough]];
    case Form::quadratic:
    case Form::exponential:
    case Form::hinge:
    case Form::step:
      parameters.push_back(shape_parameter(term));
      break;
    case Form::sine: {
      parameters.push_back({"b", unit, std::nullopt, either, std::nullopt});
      const double span = term.x.seen.high - term.x.seen.low;
      parameters.push_back({"c", "", std::nullopt, {span / 20, 2 * span}, std::nullopt});
      break;
    }
    default:
      break;
  }
  return parameters;
}

// Returns the crossing of a law of this covariate: the value at which the law may be zero.
Parameter crossing_parameter(const char* name, const Covariate& x, bool is_logarithmic) {
  const auto [low, high] = x.seen;
  const double reach = 3 * (high - low);
  return {name, "", std::nullopt,
          is_logarithmic ? Range{low / 20, high * 20} : Range{low - reach, high + reach},
          std::nullopt};
}

struct Crossing {
  double x = 0;
  double y = 0;
};

double value_of(const Term& term, double x, double y, const double* parameters,
                const Crossing& crossing) {
  const double a = parameters[0];
  if (term.form == Form::constant) return a;
  x = std::clamp(x, term.x.seen.low, term.x.seen.high);
  switch (term.form) {
    case Form::linear:
      return a * (x - crossing.x);
    case Form::log:
      return a * std::log(x / crossing.x);
    case Form::power:
      return a * (std::pow(x / crossing.x, parameters[1]) - 1);
    case Form::scaling:
      return a * std::pow(x / crossing.x, parameters[1]);
    case Form::quadratic:
      return a * (x - parameters[1]) * (x - parameters[1]);
    case Form::exponential:
      return a * (1 - std::exp(-x / parameters[1]));
    case Form::hinge:
      return a * std::max(0.0, x - parameters[1]);
    case Form::step:
      return x > parameters[1] ? a : 0;
    case Form::sine: {
      const double turn = 2 * std::numbers::pi * x / parameters[2];
      return a * std::sin(turn) + parameters[1] * std::cos(turn);
    }
    case Form::product:
      return a * factor(term.x, x, crossing.x) * factor(term.y, y, crossing.y);
    case Form::constant:
      break;
  }
  return a;
}

double sensor_covariate(const Covariate& x, std::span<Sensor> sensors, const Sensor& own,
                        const Conditions& conditions) {
  if (x.kind == CovariateKind::tension) {
    const Sensor* other = find_sensor(sensors, x.segment);
    return other == nullptr ? x.middle : other->reading_N;
  }
  return covariate_value(x, conditions, own.reading_N);
}

class Law final : public Cause {
 public:
  explicit Law(Term term, bool is_crossing_free = false)
      : term_(std::move(term)),
        is_crossing_free_(is_crossing_free),
        text_(fmt::format(
            "{} of {}{}{}", target_name(term_.target), site_name(term_.site),
            term_.form == Form::constant
                ? ""
                : ", " + covariate_name(term_.x) +
                      (term_.form == Form::product ? " x " + covariate_name(term_.y) : ""),
            term_.form == Form::constant ? "" : fmt::format(", {}", form_name(term_.form)))),
        parameters_(parameters_of(term_)) {
    if (!is_crossing_free_) return;
    const bool of_two = term_.form == Form::product;
    parameters_.push_back(crossing_parameter(
        "x0", term_.x, term_.form == Form::log || (of_two && term_.x.logarithmic)));
    if (of_two) parameters_.push_back(crossing_parameter("y0", term_.y, term_.y.logarithmic));
  }

  const Term& term() const { return term_; }
  bool is_crossing_free() const { return is_crossing_free_; }

  const char* name() const override { return "law"; }
  Reach reach() const override {
    switch (term_.site.place) {
      case SitePlace::contacts:
        return term_.target == Target::force || uses(CovariateKind::load) ? Reach::load
                                                                          : Reach::conditions;
      case SitePlace::motor:
        return Reach::motor;
      default:
        return Reach::reading;
    }
  }
  const char* meaning() const override { return text_.c_str(); }
  std::vector<Parameter> parameters(const Hardware&) const override { return parameters_; }
  std::vector<Subject> subjects(const Survey&) const override { return std::vector<Subject>(1); }
  std::string subject_name(const Subject&) const override { return text_; }

  double exponent(double phi, const ContactLoad& contact, const Conditions& conditions,
                  const Effect& effect) const override {
    if (!causes::acts_on(term_.site, contact) || !acts_in(term_.site, conditions)) return phi;
    const double f = value(conditions, contact.high_N, effect);
    if (term_.target == Target::force) {
      return std::max(0.0, exponent_with_force(phi, contact.high_N, f));
    }
    return std::max(0.0, is_tube_or_sheath(contact.kind) ? phi * (1 + f) : phi + f);
  }

  double at_tendon(double motor_tension_N, Direction direction, const Conditions& conditions,
                   const Effect& effect) const override {
    if (!acts_in(term_.site, direction) || !acts_in(term_.site, conditions)) {
      return motor_tension_N;
    }
    const double f = value(conditions, motor_tension_N, effect);
    if (term_.target == Target::gain) return motor_tension_N * (1 + f);
    const bool turns = term_.target == Target::force && direction == Direction::pull;
    return motor_tension_N + (turns ? -f : f);
  }

  void read(std::span<Sensor> sensors, Direction direction, const Conditions& conditions,
            const Effect& effect) const override {
    if (!acts_in(term_.site, direction) || !acts_in(term_.site, conditions)) return;
    std::array<double, 8> few{};
    std::vector<double> many;
    std::span<double> f = few;
    if (sensors.size() > few.size()) {
      many.resize(sensors.size());
      f = many;
    }
    for (std::size_t s = 0; s < sensors.size(); ++s) {
      const Sensor& own = sensors[s];
      if (!reads(own)) continue;
      f[s] = value(sensor_covariate(term_.x, sensors, own, conditions),
                   sensor_covariate(term_.y, sensors, own, conditions), effect.values);
    }
    for (std::size_t s = 0; s < sensors.size(); ++s) {
      if (!reads(sensors[s])) continue;
      sensors[s].reading_N = term_.target == Target::gain ? sensors[s].reading_N * (1 + f[s])
                                                          : sensors[s].reading_N + f[s];
    }
  }
  bool reads_linearly() const override {
    return term_.site.place == SitePlace::contacts || term_.site.place == SitePlace::motor ||
           !(uses(CovariateKind::load) || uses(CovariateKind::tension));
  }

 private:
  bool reads(const Sensor& sensor) const {
    return term_.site.place == SitePlace::channels || sensor.segment == term_.site.channel;
  }
  bool uses(CovariateKind kind) const {
    return term_.form != Form::constant &&
           (term_.x.kind == kind || (term_.form == Form::product && term_.y.kind == kind));
  }
  double value(const Conditions& conditions, double high_N, const Effect& effect) const {
    return value(covariate_value(term_.x, conditions, high_N),
                 covariate_value(term_.y, conditions, high_N), effect.values);
  }
  double value(double x, double y, const std::vector<double>& values) const {
    Crossing crossing{term_.x.middle, term_.y.middle};
    if (is_crossing_free_) {
      crossing.x = values[1];
      if (values.size() > 2) crossing.y = values[2];
    }
    return value_of(term_, x, y, values.data(), crossing);
  }

  Term term_;
  bool is_crossing_free_;
  std::string text_;
  std::vector<Parameter> parameters_;
};

std::optional<TermFault> fault(const Covariate& x, bool is_logarithmic) {
  if (!(x.seen.low < x.seen.high)) return TermFault{"range", "the lower end before the upper one"};
  if (!is_logarithmic) return std::nullopt;
  if (!(x.seen.low > 0)) return TermFault{"range", "a range above 0, as of a logarithm or power"};
  if (!(x.middle > 0)) return TermFault{"middle", "a middle above 0, as of a logarithm or power"};
  return std::nullopt;
}

}  // namespace

double covariate_value(const Covariate& covariate, const Conditions& conditions, double high_N) {
  switch (covariate.kind) {
    case CovariateKind::none:
    case CovariateKind::tension:
      return covariate.middle;
    case CovariateKind::load:
      return high_N;
    case CovariateKind::motor:
      return conditions.motor_tension_N;
    case CovariateKind::speed:
      return conditions.speed_mm_s;
    case CovariateKind::cycle:
      return conditions.cycle;
    case CovariateKind::temperature:
      return conditions.temperature_C;
    case CovariateKind::column:
      break;
  }
  if (!conditions.record) return covariate.middle;
  for (const NamedValue& column : conditions.record->columns) {
    if (column.name == covariate.column) return column.value;
  }
  return covariate.middle;
}

double law_value(const Term& term, double x, double y, const double* parameters) {
  return value_of(term, x, y, parameters, {term.x.middle, term.y.middle});
}

bool acts_on(const Site& site, ContactKind kind) {
  if (site.place != SitePlace::contacts) return false;
  return kind == site.kind || (site.with_sheaths && kind == ContactKind::sheath);
}

bool acts_in(const Site& site, Direction direction) {
  return !site.direction || *site.direction == direction;
}

bool acts_on(const Site& site, const ContactLoad& contact) {
  if (!acts_on(site, contact.kind) || !acts_in(site, contact.direction)) return false;
  if (site.finger != 0 && contact.finger != site.finger) return false;
  if (site.at_fingers && (contact.finger != 0) != *site.at_fingers) return false;
  if (site.held && (contact.finger == 0 || contact.grasp.holds(contact.finger) != *site.held)) {
    return false;
  }
  if (!site.routing.empty() && contact.routing != site.routing) return false;
  return !site.number || contact.number == *site.number;
}

bool acts_in(const Site& site, const Conditions& conditions) {
  if (site.runs.empty() && site.group.empty()) return true;
  if (!conditions.record) return false;
  const std::vector<std::string>& runs = site.runs;
  return (runs.empty() || std::ranges::find(runs, conditions.record->run) != runs.end()) &&
         (site.group.empty() || conditions.record->group == site.group);
}

std::optional<TermFault> fault(const Term& term) {
  const SitePlace place = term.site.place;
  const bool at_contacts = place == SitePlace::contacts;
  const bool at_motor = place == SitePlace::motor;
  if (term.target == Target::exponent && !at_contacts) {
    return TermFault{"site", "contacts, which have an exponent"};
  }
  if (term.target == Target::force && !at_contacts && !at_motor) {
    return TermFault{"site", "contacts or the motor, which take a force"};
  }
  if ((term.target == Target::gain || term.target == Target::offset) && at_contacts) {
    return TermFault{"site", "a channel, all channels or the motor, which have gain and offset"};
  }
  if (term.form == Form::constant) return std::nullopt;
  const bool of_two = term.form == Form::product;
  if ((at_contacts || at_motor) && (term.x.kind == CovariateKind::tension ||
                                    (of_two && term.y.kind == CovariateKind::tension))) {
    return TermFault{"covariate", "no other channel, but for a law of channels"};
  }
  const bool is_logarithmic =
      term.form == Form::log || term.form == Form::power || term.form == Form::scaling;
  if (const auto found = fault(term.x, is_logarithmic || (of_two && term.x.logarithmic))) {
    return found;
  }
  if (of_two) return fault(term.y, term.y.logarithmic);
  if (term.form == Form::exponential && term.x.seen.high <= 0) {
    return TermFault{"range", "an upper end above 0, as of an exponential"};
  }
  return std::nullopt;
}

namespace {

const Law& interned(const Term& term, bool is_crossing_free) {
  static std::mutex mutex;
  static std::map<std::pair<Term, bool>, std::unique_ptr<const Law>> laws;
  const std::lock_guard<std::mutex> lock(mutex);
  std::unique_ptr<const Law>& found = laws[{term, is_crossing_free}];
  if (!found) found = std::make_unique<const Law>(term, is_crossing_free);
  return *found;
}

}  // namespace

const Cause& law(const Term& term) { return interned(term, false); }

bool has_crossing(const Term& term) {
  return term.form == Form::linear || term.form == Form::log || term.form == Form::product;
}

const Cause& law_with_free_crossing(const Term& term) { return interned(term, true); }

Effect with_crossing_held(const Effect& effect) {
  const auto* free = dynamic_cast<const Law*>(effect.cause);
  if (free == nullptr || !free->is_crossing_free()) return effect;
  Term term = free->term();
  term.x.middle = effect.values[1];
  if (term.form == Form::product) term.y.middle = effect.values[2];
  return {&law(term), effect.subject, {effect.values[0]}};
}

const Term* term_of(const Cause& cause) {
  const auto* law = dynamic_cast<const Law*>(&cause);
  return law == nullptr ? nullptr : &law->term();
}

std::vector<Covariate> covariates(const Effect& effect) {
  const Term* term = term_of(*effect.cause);
  if (term == nullptr || term->form == Form::constant) return {};
  if (term->form == Form::product) return {term->x, term->y};
  return {term->x};
}

}  // namespace reeve::causes
