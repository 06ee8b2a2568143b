// A cause: one way in which a rig can differ from the model, with a physical size.
//
// A cause acts where its nature is: on the hardware, on the friction exponent of a contact (also as
// a function of the tension there), on the grasp, on the contacts of a routing, on what arrives of
// the motor's pull at the tendon, or on what the sensors read. At its nominal value it changes
// nothing. Each is a row of a table in library/, below its law, units, literature and source;
// whoever solves, fits, saves or prints models knows causes through this header only.
#pragma once

#include <compare>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/grasp.hpp"
#include "core/hardware.hpp"
#include "core/network.hpp"

namespace reeve::causes {

// A further column of a reading, and what the file records of the reading besides.
struct NamedValue {
  std::string name;
  double value = 0;
};
struct Record {
  std::string run;
  std::string group;
  std::vector<NamedValue> columns;
};

// Conditions of a reading. A missing one has the reference value, at which the laws of friction
// with speed, wear and temperature change nothing.
struct Conditions {
  double motor_tension_N = 10;  // recorded value; in a solve, that at the tendon's start
  double speed_mm_s = 10;
  double cycle = 0;
  double temperature_C = 20;
  double order = 0;  // place of the reading in its file: 0 the first, 1 the last
  std::shared_ptr<const Record> record{};
};

struct Range {
  double low = 0;
  double high = 0;

  auto operator<=>(const Range&) const = default;
};

struct Parameter {
  const char* name = "";
  const char* unit = "1";
  // Value at which the cause changes nothing. Only the first parameter has one: it is the size.
  // Others shape the law and say nothing while the size is nominal.
  std::optional<double> nominal;
  Range range;  // range of the search
  std::optional<Range> literature;
  // The range ends where the law does, not where the search does.
  bool ends_by_nature = false;
};

// Ranges in newton are of loads about 20 N; those that are searched go with the loads of the data.
inline constexpr double range_load_N = 20;
bool is_force(const Parameter& parameter);  // or a force per something
// Returns the range in a stored or simulated model: for forces, of loads up to 1000 times as great.
Range valid_range(const Parameter& parameter);

// Subject of a cause. The cause decides which members it uses.
struct Subject {
  std::optional<Segment> channel;
  std::optional<Segment> other_channel;
  int finger = 0;
  std::string routing;  // word
  std::string contact;  // "T1-T2"
  std::optional<Grasp> recorded;
  std::optional<Grasp> actual;
};

// A cause with its size.
struct Effect;

// Content of the data. It decides which causes can be asked for, and with which subjects.
struct SurveyedRouting {
  std::string word;
  const Network* network = nullptr;
  std::vector<Grasp> recorded;
};
// A covariate, and between which values it is.
struct SurveyedColumn {
  std::string name;
  Range range;
};
struct Survey {
  std::vector<SurveyedRouting> routings;
  std::vector<Segment> channels;
  std::vector<Segment> wide_channels;  // channels with readings far above and far below each other
  bool has_speed = false;
  bool has_cycle = false;
  bool has_temperature = false;
  bool has_motor_tension = false;
  bool has_both_directions = false;
  bool sheath_angle_varies = false;  // true if it differs between rows
  bool reads_below_zero = false;     // true if a channel does, as after a drift of its zero
  // These two describe a planned experiment, for laws that are given by name.
  std::size_t runs = 0;  // "1", "2", …
  std::vector<SurveyedColumn> columns{};
};

// One subject for each channel.
std::vector<Subject> channel_subjects(const std::vector<Segment>& channels);

// A contact while the tendon runs through it.
struct ContactLoad {
  ContactKind kind = ContactKind::tube;
  double high_N = 0;       // the larger of the tensions beside it
  std::size_t number = 0;  // index among those of its kind in the routing's network, from 0
  Direction direction = Direction::pull;
  int finger = 0;  // same as Contact::finger
  Grasp grasp{};
  std::string_view routing{};  // word
};

// One of the sensors that read a routing at the same time.
struct Sensor {
  Segment segment;
  double reading_N = 0;                 // so far: first the tension of its segment
  std::optional<std::size_t> column{};  // in the order of the data's channels, if it is one
};

// nullptr if this routing has no such segment.
Sensor* find_sensor(std::span<Sensor> sensors, const Segment& segment);

enum class Reach : std::uint8_t {
  hardware,    // change_hardware
  exponent,    // exponent, whatever the tension and the conditions
  conditions,  // exponent, whatever the tension
  load,        // exponent, as a function of the tension
  grasp,       // actual_grasp
  contact,     // seized_contact
  motor,       // at_tendon
  reading,     // read, or reading where a sensor minds none but itself
};

// Members of the subject that a cause uses.
enum class SubjectKind : std::uint8_t {
  rig,       // none: the cause is about the whole rig
  channel,   // channel
  channels,  // channel, other_channel
  finger,    // finger
  grasp,     // routing, recorded, actual
  contact,   // routing, contact
};

class Cause {
 public:
  Cause() = default;
  virtual ~Cause() = default;
  Cause(const Cause&) = delete;
  Cause& operator=(const Cause&) = delete;

  virtual const char* name() const = 0;
  virtual Reach reach() const = 0;
  virtual const char* meaning() const = 0;  // for a person: "the friction of the tubes differs"
  // `hardware` is the one that the effect is seen against. No parameters: it is there or not.
  virtual std::vector<Parameter> parameters(const Hardware& hardware) const = 0;
  virtual std::vector<Subject> subjects(const Survey& survey) const = 0;
  virtual SubjectKind subject_kind() const { return SubjectKind::rig; }
  // Returns the text in brackets behind the name; empty if the cause is about the whole rig.
  virtual std::string subject_name(const Subject& subject) const;
  // True if the name in brackets means the subject, too: a contact's segments in the other order.
  virtual bool is_also_named(const Subject&, std::string_view /*name*/, const Survey&) const {
    return false;
  }

  // Returns the hardware's law of a kind of contact if the cause is the coefficient of that kind;
  // otherwise nullptr.
  virtual const ContactLaw* law(const Hardware&) const { return nullptr; }

  // True if the cause acts at contacts of this kind.
  virtual bool acts_at(ContactKind) const { return false; }
  // Returns the name of the covariate over which the cause shows; empty if there is none.
  virtual const char* follows() const { return ""; }

  // Each of the following is called for causes of its reach only.
  virtual void change_hardware(Hardware&, const Effect&) const {}
  virtual double exponent(double phi, const ContactLoad&, const Conditions&, const Effect&) const {
    return phi;
  }
  virtual Grasp actual_grasp(const std::string&, Grasp recorded, const Effect&) const {
    return recorded;
  }
  virtual std::optional<std::size_t> seized_contact(const std::string&, const Network&,
                                                    const Effect&) const {
    return std::nullopt;
  }
  // Returns the tension at the tendons if the motor is said to pull `motor_tension_N`. Only
  // readings with a recorded motor tension need it. Without one, the tendon's own tension is found.
  virtual double at_tendon(double motor_tension_N, Direction, const Conditions&,
                           const Effect&) const {
    return motor_tension_N;
  }
  virtual double reading(double tension_N, const Segment&, const Effect&) const {
    return tension_N;
  }
  // All sensors of a routing at once.
  virtual void read(std::span<Sensor> sensors, Direction, const Conditions&,
                    const Effect& effect) const;
  // True if readings of its channel from the least to the greatest could show it.
  virtual bool shows_between(double /*least_N*/, double /*greatest_N*/, const Effect&) const {
    return true;
  }
  // True if readings stay linear in the tensions, up to an offset.
  virtual bool reads_linearly() const { return true; }
};

struct Effect {
  const Cause* cause = nullptr;
  Subject subject;
  std::vector<double> values;  // parallel to the parameters
};

// "sensor_gain[T3]"
std::string effect_name(const Effect& effect);

// True if both effects have the same cause and subject; the actual grasp may differ.
bool is_about_the_same(const Effect& a, const Effect& b);

// Fixed, on the carriage, or of a floating block.
inline bool is_bearing(ContactKind kind) {
  return kind == ContactKind::bearing || kind == ContactKind::block;
}
inline bool is_tube_or_sheath(ContactKind kind) {
  return kind == ContactKind::tube || kind == ContactKind::sheath;
}

// The exponent that stands for T_low = T_high e^{-phi} - F at this T_high; at most max_exponent.
double exponent_with_force(double phi, double high_N, double force_N);

}  // namespace reeve::causes
