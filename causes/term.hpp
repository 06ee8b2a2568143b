// A term: something that a rig does otherwise, in the grammar (target, site, law of a covariate).
//
//   exponent   phi' = phi (1 + f) at tubes and sheaths, phi + f at bearings and blocks, not below 0
//   force      T_low = T_high e^{-phi} - f at contacts;  T_in = T_M - f pulling, + f releasing at
//              the motor, before the tendons begin
//   gain       T (1 + f) of what a channel reads, or of what arrives of the motor's pull
//   offset     T + f of either
//
// f(x) of a covariate x, seen between two values and held constant outside them:
//
//   constant a · linear a (x - x0) · log a ln(x/x0) · power a ((x/x0)^b - 1) ·
//   scaling a (x/x0)^b · quadratic a (x - b)^2 · exponential a (1 - e^{-x/b}) ·
//   hinge a max(0, x - b) · step a [x > b] · sine a sin(2 pi x/c) + b cos(2 pi x/c) ·
//   product a g(x) h(y), g and h linear or log
//
// x0 is the middle of the data, so that a is known apart from what is common to all readings. A
// scaling law is for what begins at x = 0, as a force does that grows with the load, and has no
// constant of its own beside it. A reading that does not say x is as one at x0. The laws that a
// library of causes names by a name of their own are the same terms; what has no name there is
// called a law.
#pragma once

#include <compare>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "causes/cause.hpp"

namespace reeve::causes {

enum class Target : std::uint8_t { exponent, force, gain, offset };
const char* target_name(Target target);
std::optional<Target> target_named(const std::string& name);
std::string target_names();  // "exponent, force, …", for messages

enum class SitePlace : std::uint8_t { contacts, channel, channels, motor };

// Site says where a term acts. A member that is not set restricts nothing.
struct Site {
  SitePlace place = SitePlace::contacts;
  ContactKind kind = ContactKind::tube;  // contacts
  bool with_sheaths = false;             // contacts: sheaths besides the tubes
  int finger = 0;                        // contacts of this one
  std::optional<bool> at_fingers{};      // contacts of fingertips, or of what is fixed or carried
  std::optional<bool> held{};            // contacts of fingers that an object holds, or of others
  std::optional<Direction> direction{};  // while the motor moves this way
  std::string routing{};                 // contacts, in this word
  std::optional<std::size_t> number{};   // contacts: that of the kind in the routing, from 0
  Segment channel{};                     // channel
  std::vector<std::string> runs{};       // in these only
  std::string group{};                   // in this one only

  auto operator<=>(const Site&) const = default;
};

enum class CovariateKind : std::uint8_t {
  none,
  load,     // T_high at the contact, or what the channel carries
  tension,  // tension of another channel of the row
  motor,    // tension, N
  speed,
  cycle,
  temperature,
  column,  // any other that the file records, order and number of the run among them
};

struct Covariate {
  CovariateKind kind = CovariateKind::none;
  std::string column;  // its name in the data
  Segment segment;     // tension
  double middle = 0;   // x0
  Range seen;
  bool logarithmic = false;  // in a product

  auto operator<=>(const Covariate&) const = default;
};
// True if the tensions themselves say it, and no setting or record.
inline bool is_of_tensions(const Covariate& covariate) {
  return covariate.kind == CovariateKind::load || covariate.kind == CovariateKind::tension;
}
// "humidity_pct", "load", "T2"
std::string covariate_name(const Covariate& covariate);
// Returns the covariate of this name, without middle and range. A name that means nothing else is a
// column's.
Covariate covariate_named(const std::string& name);

enum class Form : std::uint8_t {
  constant,
  linear,
  log,
  power,
  scaling,
  quadratic,
  exponential,
  hinge,
  step,
  sine,
  product,
};
const char* form_name(Form form);
std::optional<Form> form_named(const std::string& name);
std::string form_names();

struct Term {
  Target target = Target::exponent;
  Site site;
  Form form = Form::constant;
  Covariate x{};
  Covariate y{};  // product

  auto operator<=>(const Term&) const = default;
};

// f, of the parameters in the order of the form. The first of them is 0 if the term changes
// nothing.
double law_value(const Term& term, double x, double y, const double* parameters);
// x as the readings' conditions say it; x0 where they do not. `high_N` stands for the load.
double covariate_value(const Covariate& covariate, const Conditions& conditions, double high_N);

bool acts_on(const Site& site, ContactKind kind);
bool acts_on(const Site& site, const ContactLoad& contact);
bool acts_in(const Site& site, Direction direction);
// In one of these runs, and in this group.
bool acts_in(const Site& site, const Conditions& conditions);

// "sheath", "tube and sheath of finger 1", "T3 in release", "motor", "all channels"
std::string site_name(const Site& site);
std::string kind_name(const Site& site);  // of contacts: "tube and sheath"
// The site of this name, whatever it says of a routing; nothing if it names none.
std::optional<Site> site_named(const std::string& name);

// Fault of an impossible term: the key in files of the part that does not go with the others.
struct TermFault {
  const char* key;
  const char* expected;
};
std::optional<TermFault> fault(const Term& term);

// The cause that does what the term says. One and the same for equal terms, and never gone.
const Cause& law(const Term& term);
// Nothing of a cause that is none.
const Term* term_of(const Cause& cause);

// The same law with x0 (and y0 of a product) among its parameters, behind the others: for a search
// that does not know where the law is zero. Only of those that have one number for it: linear, log
// and product.
bool has_crossing(const Term& term);
const Cause& law_with_free_crossing(const Term& term);
// Its effect as one of a plain law, whose term holds the crossing; any other effect as it is.
Effect with_crossing_held(const Effect& effect);

// Returns the covariates of the effect's law: none, one or two.
std::vector<Covariate> covariates(const Effect& effect);

// "phi' = phi (1 + 0.0083 (humidity_pct - 50))"
std::string formula(const Term& term, const std::vector<double>& values);

}  // namespace reeve::causes
