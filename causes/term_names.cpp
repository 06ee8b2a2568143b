#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string>
#include <string_view>

#include "causes/term.hpp"

namespace reeve::causes {
namespace {

constexpr std::array names_of_targets{"exponent", "force", "gain", "offset"};
constexpr std::array names_of_forms{"constant", "linear",    "log",         "power",
                                    "scaling",  "quadratic", "exponential", "hinge",
                                    "step",     "sine",      "product"};

template <typename Enum, std::size_t n>
std::optional<Enum> enum_named(const std::array<const char*, n>& names, const std::string& name) {
  const auto found = std::ranges::find(names, name);
  if (found == names.end()) return std::nullopt;
  return static_cast<Enum>(found - names.begin());
}

struct NamedCovariate {
  CovariateKind kind;
  const char* name;
};
constexpr std::array named_covariates{NamedCovariate{CovariateKind::load, "load"},
                                      NamedCovariate{CovariateKind::motor, "motor_tension_N"},
                                      NamedCovariate{CovariateKind::speed, "speed_mm_s"},
                                      NamedCovariate{CovariateKind::cycle, "cycle"},
                                      NamedCovariate{CovariateKind::temperature, "temperature_C"}};

const NamedCovariate* find_named_covariate(std::string_view name) {
  const auto* found = std::ranges::find(named_covariates, name, &NamedCovariate::name);
  return found == named_covariates.end() ? nullptr : found;
}

// Before the name of a column that by itself would be read as something else.
constexpr std::string_view column_prefix = "column ";

// Returns the segment of this name. A word of two letters or more means a column rather than a
// motor-side segment.
std::optional<Segment> tension_named(const std::string& name) {
  const auto segment = segment_named(name);
  const bool is_word = segment && segment->kind == SegmentKind::motor_side && name.size() > 1;
  return is_word ? std::nullopt : segment;
}

bool means_another(const std::string& column) {
  return find_named_covariate(column) != nullptr || tension_named(column).has_value() ||
         column.starts_with(column_prefix);
}

constexpr std::string_view and_sheath = " and sheath";
constexpr std::string_view run_mark = " in run ";
constexpr std::string_view runs_mark = " in runs ";
constexpr std::string_view between_runs = ", ";
constexpr std::string_view group_mark = " in group ";

// The text of site_name, read from its beginning.
class SiteReader {
 public:
  explicit SiteReader(std::string_view text) : rest_(text) {}

  std::optional<Site> site() {
    split_off_runs_and_group();
    if (!read_place() || !rest_.empty() || std::ranges::count(site_.runs, "") > 0) {
      return std::nullopt;
    }
    return site_;
  }

 private:
  // If both are there, the runs stand first. A name may itself contain such words.
  void split_off_runs_and_group() {
    const std::size_t one = rest_.find(run_mark);
    const std::size_t more = rest_.find(runs_mark);
    if (std::min(one, more) >= rest_.find(group_mark)) {
      site_.group = split_off(rest_, rest_.find(group_mark), group_mark);
      return;
    }
    std::string_view names =
        split_off(rest_, std::min(one, more), one < more ? run_mark : runs_mark);
    site_.group = split_off(names, names.rfind(group_mark), group_mark);
    if (one < more) {
      site_.runs = {std::string(names)};
      return;
    }
    for (std::size_t end = 0; end != std::string_view::npos;) {
      end = names.find(between_runs);
      site_.runs.emplace_back(names.substr(0, end));
      if (end != std::string_view::npos) names.remove_prefix(end + between_runs.size());
    }
  }

  // Cuts a text off at the mark and returns what stands behind it; "" if there is no mark.
  static std::string_view split_off(std::string_view& text, std::size_t at, std::string_view mark) {
    if (at == std::string_view::npos) return "";
    const std::string_view name = text.substr(at + mark.size());
    text = text.substr(0, at);
    return name;
  }

  bool read_place() {
    if (take("motor")) {
      site_.place = SitePlace::motor;
      read_direction();
      return true;
    }
    if (take("all channels")) {
      site_.place = SitePlace::channels;
      read_direction();
      return true;
    }
    for (const ContactKind kind :
         {ContactKind::tube, ContactKind::bearing, ContactKind::sheath, ContactKind::block}) {
      if (!take(contact_kind_name(kind))) continue;
      site_.kind = kind;
      site_.with_sheaths = kind == ContactKind::tube && take(and_sheath);
      return read_restrictions();
    }
    const std::string_view segment = rest_.substr(0, rest_.find(' '));
    const auto channel = segment_named(segment);
    if (!channel) return false;
    site_.place = SitePlace::channel;
    site_.channel = *channel;
    rest_.remove_prefix(segment.size());
    read_direction();
    return true;
  }

  void read_direction() {
    if (take(" in pull")) {
      site_.direction = Direction::pull;
    } else if (take(" in release")) {
      site_.direction = Direction::release;
    }
  }

  bool read_restrictions() {
    const bool of_one = rest_.size() > 1 && rest_[0] == ' ' && is_digit(rest_[1]);
    if (of_one) {
      rest_.remove_prefix(1);
      const std::size_t number = take_number();
      if (number == 0 || site_.with_sheaths) return false;
      site_.number = number - 1;
    }
    if (take(" of finger ")) {
      site_.finger = static_cast<int>(take_number());
      if (site_.finger == 0 || site_.finger > max_fingers) return false;
    } else if (take(" of fingers")) {
      site_.at_fingers = true;
    } else if (take(" of the hand")) {
      site_.at_fingers = false;
    }
    if (take(" of held fingers")) {
      site_.held = true;
    } else if (take(" of closing fingers")) {
      site_.held = false;
    }
    read_direction();
    if (take(" of ")) {
      site_.routing = rest_;
      rest_ = {};
      return !site_.routing.empty();
    }
    return true;
  }

  bool take(std::string_view prefix) {
    if (!rest_.starts_with(prefix)) return false;
    rest_.remove_prefix(prefix.size());
    return true;
  }

  // 0 if there is none, or one beyond all that there are.
  std::size_t take_number() {
    std::size_t number = 0;
    while (!rest_.empty() && is_digit(rest_[0])) {
      number = std::min<std::size_t>(10 * number + static_cast<std::size_t>(rest_[0] - '0'), 10000);
      rest_.remove_prefix(1);
    }
    return number == 10000 ? 0 : number;
  }

  static bool is_digit(char c) { return c >= '0' && c <= '9'; }

  std::string_view rest_;
  Site site_;
};

// " + 5", or " - 5" of "-5".
std::string added(const std::string& text) {
  return text[0] == '-' ? " - " + text.substr(1) : " + " + text;
}

// " - 5", or " + 5" of -5.
std::string subtracted(double value) { return added(fmt::format("{:.4g}", -value)); }

std::string factor_text(const Covariate& covariate) {
  const std::string name = covariate_name(covariate);
  return covariate.logarithmic ? fmt::format("ln({} / {:.4g})", name, covariate.middle)
                               : fmt::format("({}{})", name, subtracted(covariate.middle));
}

}  // namespace

const char* target_name(Target target) {
  return names_of_targets[static_cast<std::size_t>(target)];
}
std::optional<Target> target_named(const std::string& name) {
  return enum_named<Target>(names_of_targets, name);
}
std::string target_names() { return fmt::format("{}", fmt::join(names_of_targets, ", ")); }
const char* form_name(Form form) { return names_of_forms[static_cast<std::size_t>(form)]; }
std::optional<Form> form_named(const std::string& name) {
  return enum_named<Form>(names_of_forms, name);
}

std::string form_names() { return fmt::format("{}", fmt::join(names_of_forms, ", ")); }

std::string covariate_name(const Covariate& covariate) {
  switch (covariate.kind) {
    case CovariateKind::none:
      return "";
    case CovariateKind::tension:
      return segment_name(covariate.segment);
    case CovariateKind::column:
      return std::string(means_another(covariate.column) ? column_prefix : "") + covariate.column;
    default:
      break;
  }
  const auto* named = std::ranges::find(named_covariates, covariate.kind, &NamedCovariate::kind);
  return named->name;
}

Covariate covariate_named(const std::string& name) {
  Covariate covariate;
  if (const NamedCovariate* named = find_named_covariate(name)) {
    covariate.kind = named->kind;
  } else if (const auto segment = tension_named(name)) {
    covariate.kind = CovariateKind::tension;
    covariate.segment = *segment;
  } else {
    covariate.kind = CovariateKind::column;
    covariate.column = name.starts_with(column_prefix) ? name.substr(column_prefix.size()) : name;
  }
  return covariate;
}

std::string kind_name(const Site& site) {
  return std::string(contact_kind_name(site.kind)).append(site.with_sheaths ? and_sheath : "");
}

std::string site_name(const Site& site) {
  std::string name;
  switch (site.place) {
    case SitePlace::motor:
      name = "motor";
      break;
    case SitePlace::channels:
      name = "all channels";
      break;
    case SitePlace::channel:
      name = segment_name(site.channel);
      break;
    case SitePlace::contacts:
      name = kind_name(site);
      if (site.number) name += fmt::format(" {}", *site.number + 1);
      if (site.finger != 0) name += fmt::format(" of finger {}", site.finger);
      if (site.at_fingers) name += *site.at_fingers ? " of fingers" : " of the hand";
      if (site.held) name += *site.held ? " of held fingers" : " of closing fingers";
      break;
  }
  if (site.direction) name += *site.direction == Direction::pull ? " in pull" : " in release";
  if (!site.routing.empty()) name += fmt::format(" of {}", site.routing);
  if (!site.runs.empty()) name.append(site.runs.size() == 1 ? run_mark : runs_mark);
  name += fmt::format("{}", fmt::join(site.runs, between_runs));
  if (!site.group.empty()) name.append(group_mark).append(site.group);
  return name;
}

std::optional<Site> site_named(const std::string& name) {
  std::optional<Site> site = SiteReader(name).site();
  if (site && site_name(*site) != name) site.reset();
  return site;
}

std::string formula(const Term& term, const std::vector<double>& values) {
  const std::string x = covariate_name(term.x);
  // A force is taken off.
  const double sign = term.target == Target::force ? -1 : 1;
  const std::string a = fmt::format("{:.4g}", sign * values[0]);
  std::string f;
  switch (term.form) {
    case Form::constant:
      f = a;
      break;
    case Form::linear:
      f = fmt::format("{} ({}{})", a, x, subtracted(term.x.middle));
      break;
    case Form::log:
      f = fmt::format("{} ln({} / {:.4g})", a, x, term.x.middle);
      break;
    case Form::power:
      f = fmt::format("{} (({} / {:.4g})^{:.4g} - 1)", a, x, term.x.middle, values[1]);
      break;
    case Form::scaling:
      f = fmt::format("{} ({} / {:.4g})^{:.4g}", a, x, term.x.middle, values[1]);
      break;
    case Form::quadratic:
      f = fmt::format("{} ({}{})^2", a, x, subtracted(values[1]));
      break;
    case Form::exponential:
      f = fmt::format("{} (1 - exp(-{} / {:.4g}))", a, x, values[1]);
      break;
    case Form::hinge:
      f = fmt::format("{} max(0, {}{})", a, x, subtracted(values[1]));
      break;
    case Form::step:
      f = fmt::format("{} [{} > {:.4g}]", a, x, values[1]);
      break;
    case Form::sine: {
      const std::string turn = fmt::format("(2 pi {} / {:.4g})", x, values[2]);
      const std::string b = fmt::format("{:.4g}", sign * values[1]);
      f = fmt::format("{} sin{}{} cos{}", a, turn, added(b), turn);
      break;
    }
    case Form::product:
      f = fmt::format("{} {} {}", a, factor_text(term.x), factor_text(term.y));
      break;
  }
  const bool at_motor = term.site.place == SitePlace::motor;
  const char* own = at_motor ? "T_M" : "T";
  switch (term.target) {
    case Target::exponent:
      return is_tube_or_sheath(term.site.kind) ? fmt::format("phi' = phi (1{})", added(f))
                                               : "phi' = phi" + added(f);
    case Target::force:
      return (at_motor ? "T_M' = T_M" : "T_low = T_high exp(-phi)") + added(f);
    case Target::gain:
      return fmt::format("{0}' = {0} (1{1})", own, added(f));
    case Target::offset:
      return fmt::format("{0}' = {0}{1}", own, added(f));
  }
  return f;
}

}  // namespace reeve::causes
