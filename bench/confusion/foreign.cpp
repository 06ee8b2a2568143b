#include "bench/confusion/foreign.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <functional>
#include <map>
#include <numbers>
#include <optional>
#include <set>
#include <utility>

#include "bench/confusion/report.hpp"
#include "core/notation.hpp"
#include "diagnosis/fit/forecast.hpp"
#include "numerics/parallel.hpp"
#include "tests/support/planting_nature.hpp"
#include "tests/support/planting_noise.hpp"
#include "tests/support/planting_walk.hpp"
#include "tests/support/random_routing.hpp"

namespace reeve::bench {
namespace {

using testing::Condition;
using testing::ContactName;
using testing::Dice;
using testing::Nature;

using Columns = std::map<std::string, double>;

// A row as a law leaves it: its contacts (in its nature), its readings by channel, its motor.
struct Row {
  Columns columns;
  Condition condition;
  Nature nature;
  double motor_gain = 1, motor_offset_N = 0;
  std::map<std::string, double> gain, offset_N;
  std::string run;
};

const std::vector<std::string> routings{"M-1-T-2-F", "M-1-T-2-M", "F-1-P-2-F", "M-1-P-2-F",
                                        "M-1-P-2-M", "1-T-2-P-1", "1-P-2-P-1"};
const std::vector<std::string> strands{"T1", "T2", "T3", "T4"};
const std::vector<std::string> column_names{"speed_mm_s",   "cycle",     "temperature_C",
                                            "humidity_pct", "object_mm", "carriage_mm",
                                            "dwell_s",      "supply_V",  "bend_deg"};

void scale_contacts(Row& row, const std::string& kind, int finger, double factor) {
  const auto nominal =
      testing::reference_tensions(row.condition.word, row.condition.held,
                                  testing::ReferenceDirection::pull, testing::nominal_hardware());
  for (const testing::ReferenceContact& contact : nominal.contacts) {
    const int left = testing::finger_of_strand(contact.left);
    const int right = testing::finger_of_strand(contact.right);
    const bool between_fingers = left != right && left != 0 && right != 0;
    const int of = between_fingers ? 0 : std::max(left, right);
    if (contact.kind != kind || (finger != 0 && of != finger)) continue;
    row.condition.exponent_factor.try_emplace({contact.left, contact.right}, 1).first->second *=
        std::max(factor, 0.0);
  }
}

// phi' = phi (1 + f)
std::function<void(Row&)> rougher(const std::string& kind, int finger,
                                  double (*f)(const Columns&)) {
  return [=](Row& row) { scale_contacts(row, kind, finger, 1 + f(row.columns)); };
}

// Bearings have next to no exponent, so a law adds to it: phi' = phi + f.
std::function<void(Row&)> bearing_adds(double (*f)(const Columns&)) {
  return [=](Row& row) {
    const double phi = testing::nominal_hardware().bearing.mu * std::numbers::pi;
    scale_contacts(row, "bearing", 0, 1 + f(row.columns) / phi);
  };
}

struct Law {
  std::string site, acts_on, column;
  std::function<void(Row&)> plant;
  // Names by which a library calls the same.
  std::vector<std::string> also{};
};

double of(const Columns& row, const char* name) { return row.at(name); }

const std::vector<Law>& laws() {
  static const std::vector<Law> all{
      {"sheath", "exponent", "humidity_pct",
       rougher("sheath", 0, [](const Columns& c) { return 0.009 * (of(c, "humidity_pct") - 50); })},
      {"tube", "exponent", "humidity_pct",
       rougher("tube", 0, [](const Columns& c) { return -0.008 * (of(c, "humidity_pct") - 40); })},
      {"tube of finger 2", "exponent", "cycle",
       rougher("tube", 2, [](const Columns& c) { return 0.35 * of(c, "cycle") / 1000; })},
      {"all channels", "gain", "carriage_mm",
       [](Row& row) {
         const double f =
             0.05 * std::sin(2 * std::numbers::pi * of(row.columns, "carriage_mm") / 27);
         for (const std::string& strand : strands) row.gain[strand] = 1 + f;
       }},
      {"bearing", "exponent", "temperature_C",
       bearing_adds([](const Columns& c) { return 0.15 - 0.008 * (of(c, "temperature_C") - 20); })},
      {"sheath", "exponent", "humidity_pct x speed_mm_s",
       rougher("sheath", 0,
               [](const Columns& c) {
                 return 0.12 * std::log(of(c, "speed_mm_s") / 10) * (of(c, "humidity_pct") - 50) /
                        20;
               })},
      {"T3", "gain", "supply_V",
       [](Row& row) { row.gain["T3"] = 1 + 0.2 * (of(row.columns, "supply_V") - 5); }},
      {"motor", "gain", "supply_V",
       [](Row& row) { row.motor_gain = 1 + 0.15 * (of(row.columns, "supply_V") - 5); }},
      {"motor", "offset", "temperature_C",
       [](Row& row) { row.motor_offset_N = 0.06 * (of(row.columns, "temperature_C") - 22); }},
      {"T4", "offset", "temperature_C",
       [](Row& row) { row.offset_N["T4"] = 0.03 * (of(row.columns, "temperature_C") - 20); }},
      {"T2", "offset", "carriage_mm",
       [](Row& row) {
         row.offset_N["T2"] =
             0.3 * std::sin(2 * std::numbers::pi * of(row.columns, "carriage_mm") / 19);
       }},
      {"sheath of finger 2", "exponent", "cycle",
       rougher("sheath", 2, [](const Columns& c) { return of(c, "cycle") > 700 ? -0.3 : 0.0; })},
      {"sheath",
       "force",
       "humidity_pct",
       [](Row& row) {
         row.nature.bending_force_N = 0.004 * (of(row.columns, "humidity_pct") - 20);
       },
       {"law[force of tube, humidity_pct"}},
      {"tube", "exponent", "dwell_s",
       rougher("tube", 0,
               [](const Columns& c) { return 0.35 * (1 - std::exp(-of(c, "dwell_s") / 12)); })},
      {"sheath", "exponent", "bend_deg",
       rougher("sheath", 0,
               [](const Columns& c) { return 0.3 * std::pow((of(c, "bend_deg") - 60) / 60, 2); })},
      {"tube of finger 1", "exponent", "object_mm",
       rougher("tube", 1, [](const Columns& c) { return 0.006 * (of(c, "object_mm") - 50); })},
      {"sheath", "exponent", "temperature_C",
       rougher("sheath", 0,
               [](const Columns& c) { return 0.04 * std::max(0.0, of(c, "temperature_C") - 24); })},
      {"T1", "gain", "cycle",
       [](Row& row) { row.gain["T1"] = 1 - 0.07 * of(row.columns, "cycle") / 1000; }},
      {"bearing", "exponent", "cycle",
       bearing_adds([](const Columns& c) { return 0.12 * of(c, "cycle") / 1000; })},
      {"all channels", "gain", "temperature_C",
       [](Row& row) {
         const double f = 0.006 * (of(row.columns, "temperature_C") - 22);
         for (const std::string& strand : strands) row.gain[strand] = 1 + f;
       }},
      {"sheath of finger 1", "exponent", "humidity_pct",
       rougher("sheath", 1, [](const Columns& c) { return 0.009 * (of(c, "humidity_pct") - 50); })},
      {"T2", "gain", "speed_mm_s",
       [](Row& row) { row.gain["T2"] = 1 + 0.03 * std::log(of(row.columns, "speed_mm_s") / 10); }},
      {"tube", "exponent", "supply_V",
       rougher("tube", 0, [](const Columns& c) { return 0.4 * (of(c, "supply_V") - 5); })},
      {"bearing", "force", "load", [](Row& row) {
         row.nature.drag_onset_N = 4;
         row.nature.drag_slope = 0.15;
       }}};
  return all;
}

struct Rig {
  std::string csv, fresh_csv;
  double fresh_noise_N = 0;        // residual of the fresh runs by noise alone
  std::vector<std::string> truth;  // names that are right, of which one is to be named
  std::string about;
};

struct Plan {
  std::function<void(Row&)> plant = [](Row&) {};
  double mounted = 0;
  double outliers = 0;
  bool imported = false;
};

struct Table {
  std::string csv;
  double noise_N = 0;
};

std::string text(const std::set<int>& held) {
  std::string result;
  for (const int finger : held) result += (result.empty() ? "" : ";") + std::to_string(finger);
  return result;
}

Row drawn(const std::string& run, const std::string& word, double cycle, double humidity,
          double temperature, const std::set<int>& held, Dice& dice) {
  const std::vector<double> speeds{2, 5, 10, 20, 50}, dwells{1, 3, 10, 30, 100},
      objects{20, 40, 60, 80};
  Row row;
  row.run = run;
  row.condition.word = word;
  row.condition.held = held;
  row.condition.motor_tension_N = dice.real(5, 25);
  row.columns = {{"speed_mm_s", dice.pick(speeds)},
                 {"cycle", cycle},
                 {"temperature_C", std::round(10 * (temperature + dice.real(-0.5, 0.5))) / 10},
                 {"humidity_pct", humidity},
                 {"object_mm", dice.pick(objects)},
                 {"carriage_mm", std::round(10 * dice.real(0, 60)) / 10},
                 {"dwell_s", dice.pick(dwells)},
                 {"supply_V", std::round(100 * dice.real(4.6, 5.4)) / 100},
                 {"bend_deg", std::round(dice.real(0, 120))}};
  return row;
}

void mount(const std::map<ContactName, double>& factors, Row& row) {
  for (const auto& [contact, factor] : factors) {
    row.condition.exponent_factor.try_emplace(contact, 1).first->second *= factor;
  }
}

std::map<ContactName, double> mounting(const std::string& word, double scatter, Dice& dice) {
  const testing::NoiseLevel unit{0, 1, 0, 0, 0, true};
  testing::NoiseSource normal(unit, static_cast<std::uint64_t>(dice.integer(0, 1 << 30)));
  std::map<ContactName, double> factors;
  const auto nominal = testing::reference_tensions(word, {}, testing::ReferenceDirection::pull,
                                                   testing::nominal_hardware());
  for (const testing::ReferenceContact& contact : nominal.contacts) {
    factors[{contact.left, contact.right}] = 1 + scatter * normal.reading(0);
  }
  return factors;
}

Table measured(const Plan& plan, int first_run, int runs_of_each, Dice& dice) {
  constexpr int rows_of_a_run = 8;
  const testing::NoiseLevel noise{0.01, 0.02, 0, 0, 0, true};
  testing::NoiseSource source(noise, static_cast<std::uint64_t>(dice.integer(0, 1 << 30)));
  Table table;
  table.csv = "# simulated, not measured\nrun,routing,held,direction,motor_tension_N,";
  table.csv += fmt::format("{}", fmt::join(column_names, ","));
  for (const std::string& strand : strands) table.csv += "," + strand + "_N";
  if (plan.imported) table.csv += ",readings,motor_tension_sd_N,T1_sd_N,T2_sd_N,T3_sd_N,T4_sd_N";
  table.csv += "\n";
  double squares = 0;
  double count = 0;
  int run = first_run;
  for (int again = 0; again < runs_of_each; ++again) {
    for (const std::string& word : routings) {
      const auto factors = mounting(word, plan.mounted, dice);
      const double cycle = dice.integer(0, 1400), humidity = std::round(dice.real(25, 80)),
                   temperature = dice.real(16, 31);
      const std::vector<std::set<int>> grasps{{}, {1}, {2}};
      const std::set<int> held = dice.pick(grasps);
      for (int i = 0; i < rows_of_a_run; ++i) {
        Row row =
            drawn(std::to_string(run), word, cycle + 3 * i, humidity, temperature, held, dice);
        plan.plant(row);
        mount(factors, row);
        const double recorded_N = row.condition.motor_tension_N;
        row.condition.motor_tension_N = row.motor_gain * recorded_N + row.motor_offset_N;
        const auto tensions = testing::planted_tensions(row.nature, row.condition);
        table.csv += fmt::format("{},{},{},pull,{:.4f}", row.run, word, text(held), recorded_N);
        for (const std::string& name : column_names)
          table.csv += fmt::format(",{}", row.columns[name]);
        for (const std::string& strand : strands) {
          const double gain = row.gain.contains(strand) ? row.gain[strand] : 1;
          const double expected_N = gain * tensions.at(strand) + row.offset_N[strand];
          double reading_N = source.reading(expected_N);
          squares += std::pow(reading_N - expected_N, 2);
          ++count;
          if (dice.chance(plan.outliers)) {
            const double factor = dice.real(1.3, 3);
            reading_N *= dice.chance(0.5) ? factor : 1 / factor;
          }
          table.csv += fmt::format(",{:.4f}", reading_N);
        }
        // The mean of a hundred samples scatters by what a row's noise is here.
        if (plan.imported) table.csv += fmt::format(",100,{:.3f}", 0.006 * recorded_N);
        if (plan.imported) table.csv += ",0.2,0.2,0.2,0.2";
        table.csv += "\n";
      }
      ++run;
    }
  }
  table.noise_N = std::sqrt(squares / count);
  return table;
}

std::string law_name(const Law& law) {
  return fmt::format("law[{} of {}, {}", law.acts_on, law.site, law.column);
}

double mounted(std::size_t index) { return index % 3 == 2 ? 0.03 : 0; }

Rig rig_of(const Plan& plan, std::vector<std::string> truth, const std::string& about, Dice& dice) {
  const Table table = measured(plan, 1, 3, dice);
  Plan clean = plan;
  clean.outliers = 0;
  clean.mounted = 0;
  const Table fresh = measured(clean, 101, 2, dice);
  return {table.csv, fresh.csv, fresh.noise_N, std::move(truth),
          about + (plan.mounted > 0 ? ", mountings 3 %" : "")};
}

Rig law_rig(std::size_t index, Dice& dice) {
  const Law& law = laws()[index % laws().size()];
  std::vector<std::string> truth = law.also;
  truth.push_back(law_name(law));
  const std::size_t round = index / laws().size();
  return rig_of({law.plant, round % 2 == 1 ? 0.03 : 0}, truth, truth.back(), dice);
}

Rig apart_rig(std::size_t index, Dice& dice) {
  const double scatter = mounted(index / 3);
  if (index % 3 == 0) {
    const std::string run = std::to_string(dice.integer(1, 21));
    const auto bent = [run](Row& row) {
      if (row.run == run) scale_contacts(row, "sheath", 0, 1.45);
    };
    return rig_of({bent, scatter}, {"apart " + run}, "run " + run + " bent", dice);
  }
  if (index % 3 == 1) {
    const auto stiff = [](Row& row) {
      if (row.condition.word == "M-1-T-2-M") {
        row.condition.exponent_factor[{"T1", "T2"}] = 2.2;
      }
    };
    return rig_of({stiff, scatter}, {"law[exponent of tube 1 of M-1-T-2-M"}, "a contact", dice);
  }
  const int from = dice.integer(7, 15);
  const auto changed = [from](Row& row) {
    if (std::stoi(row.run) >= from) row.gain["T3"] = 1.12;
  };
  return rig_of({changed, scatter}, {"law[gain of T3, run"}, fmt::format("T3 from {}", from), dice);
}

Rig imported_rig(std::size_t index, Dice& dice) {
  Plan plan;
  plan.imported = true;
  if (index % 2 == 0) return rig_of(plan, {}, "nothing", dice);
  plan.plant = [](Row& row) { row.gain["T2"] = 1.06; };
  return rig_of(plan, {"sensor_gain[T2]"}, "gain of T2", dice);
}

// Th1 = (T_M - F) e^{-phi}, with a motor tension that scatters.
Rig bench_rig(std::size_t index, Dice& dice) {
  const double phi = dice.real(0.1, 0.4), loss_N = dice.real(1, 3);
  const testing::NoiseLevel unit{0, 1, 0, 0, 0, true};
  testing::NoiseSource normal(unit, static_cast<std::uint64_t>(dice.integer(0, 1 << 30)));
  const bool by_weight = index % 2 == 0;
  const auto table = [&](int repetitions) {
    std::string csv = "# simulated, not measured\nrun,routing,direction,motor_tension_N,Th1_N\n";
    for (int repetition = 0; repetition < repetitions; ++repetition) {
      for (const double kg : {1.0, 2.0, 3.0, 4.0, 5.0}) {
        for (int i = 0; i < 6; ++i) {
          const double weight_N = 9.81 * kg;
          const double motor_N = weight_N * std::exp(phi) + loss_N + 0.3 * normal.reading(0);
          const std::string run =
              by_weight ? fmt::format("{}kg", kg) : fmt::format("r{}", repetition);
          csv += fmt::format("{},M-F,pull,{:.4f},{:.4f}\n", run, motor_N, weight_N);
        }
      }
    }
    return csv;
  };
  const std::string csv = table(6);
  return {csv,
          table(2),
          0.3 * std::exp(-phi),
          {"constant_loss", "motor_offset"},
          fmt::format("phi {:.2f}, loss {:.1f} N, a run for each {}", phi, loss_N,
                      by_weight ? "weight" : "repetition")};
}

Rig planted_rig(const std::string& part, std::size_t index, std::uint64_t seed) {
  Dice dice(seed * 1000003 + index);
  if (part == "law") return law_rig(index, dice);
  if (part == "apart") return apart_rig(index, dice);
  if (part == "imported") return imported_rig(index, dice);
  if (part == "bench") return bench_rig(index, dice);
  Plan plan;
  plan.mounted = mounted(index);
  if (part == "outliers") plan.outliers = 0.02;
  return rig_of(plan, {}, "nothing", dice);
}

struct Diagnosed {
  bool right = false, alarm = false, loses = false, forecasts = false;
  std::string line;
};

double rms_N(const MeasuredData& data, const Model& model) {
  std::vector<std::size_t> all(data.readings.size());
  for (std::size_t i = 0; i < all.size(); ++i) all[i] = i;
  const Dataset fresh = dataset(data, all);
  const Forecast at = forecast(fresh, model);
  double sum = 0;
  for (std::size_t i = 0; i < fresh.cells.size(); ++i) {
    sum += std::pow(fresh.cells[i].measured_N - at.reading_N[static_cast<Eigen::Index>(i)], 2);
  }
  return std::sqrt(sum / static_cast<double>(fresh.cells.size()));
}

// Coefficients move with the zero of a law.
bool is_coefficient(const std::string& name) {
  return name == "tube_friction" || name == "sheath_friction" || name == "bearing_friction";
}

bool is_one_of(const std::vector<std::string>& names, const std::vector<std::string>& truth) {
  return std::any_of(names.begin(), names.end(), [&](const std::string& name) {
    return std::any_of(truth.begin(), truth.end(),
                       [&](const std::string& right) { return name.starts_with(right); });
  });
}

Diagnosed diagnosed(const Rig& rig, const DiagnoseOptions& options) {
  const MeasuredData data = parse_planted(rig.csv);
  const DiagnosisResult result = diagnose(data, {}, options);
  bool has_truth = false, has_other = false;
  std::vector<std::string> said;
  for (const NamedCause& cause : result.causes) {
    std::vector<std::string> group{cause.name};
    for (const auto& alike : result.indistinguishable) {
      if (alike.front() == cause.name) group = alike;
    }
    said.push_back(fmt::format("{}", fmt::join(group, " ~ ")));
    if (is_one_of(group, rig.truth)) {
      has_truth = true;
    } else if (!is_coefficient(cause.name)) {
      has_other = true;
    }
  }
  for (const RunsApart& apart : result.apart) {
    const std::string name = fmt::format("apart {}", fmt::join(apart.runs, " "));
    said.push_back(name);
    (is_one_of({name}, rig.truth) ? has_truth : has_other) = true;
  }
  const MeasuredData fresh = parse_planted(rig.fresh_csv);
  const double nominal_N = rms_N(fresh, {}), found_N = rms_N(fresh, result.model);
  Diagnosed found;
  found.right = rig.truth.empty() ? result.verdict == Verdict::none : has_truth && !has_other;
  found.alarm = rig.truth.empty() && !result.causes.empty();
  found.loses = !result.causes.empty() && found_N > 1.02 * nominal_N;
  found.forecasts = found_N <= 1.15 * rig.fresh_noise_N;
  found.line = fmt::format(
      "- {}: {} {}; fresh runs {:.3f} N by the model, {:.3f} N without, {:.3f} N of "
      "noise{}\n",
      rig.about, verdict_name(result.verdict), fmt::join(said, ", "), found_N, nominal_N,
      rig.fresh_noise_N, result.unexplained ? "; left: " + result.unexplained->where : "");
  return found;
}

std::string row(const std::string& what, const Rate& rate) {
  return fmt::format("| {} | {} of {} | {:.0f} to {:.0f} % |\n", what, rate.hits, rate.of,
                     100 * rate.low(), 100 * rate.high());
}

}  // namespace

const std::vector<std::string>& foreign_parts() {
  static const std::vector<std::string> parts{"law",   "idle",     "bench",
                                              "apart", "outliers", "imported"};
  return parts;
}

std::string foreign_report(const std::string& part, std::size_t sets, std::uint64_t seed,
                           const DiagnoseOptions& options, bool list,
                           const std::filesystem::path& save) {
  std::vector<Diagnosed> found(sets);
  DiagnoseOptions single = options;
  single.threads = 1;
  Workers(options.threads).for_each_block(sets, 1, [&](const IndexBlock& block) {
    const Rig rig = planted_rig(part, block.begin, seed);
    found[block.begin] = diagnosed(rig, single);
    if (save.empty() || found[block.begin].right) return;
    std::ofstream(save / fmt::format("{}_{}.csv", part, block.begin)) << rig.csv;
  });
  Rate right, alarm, loses, forecasts;
  std::string missed;
  for (const Diagnosed& one : found) {
    right.count(one.right);
    alarm.count(one.alarm);
    loses.count(one.loses);
    forecasts.count(one.forecasts);
    if (!one.right || one.loses || !one.forecasts) missed += one.line;
  }
  return fmt::format("## {}\n\n| of {} rigs | | 95 % interval |\n| --- | --- | --- |\n", part,
                     sets) +
         row("right", right) + row("a cause named where there is none", alarm) +
         row("fresh runs forecast worse than without the named causes", loses) +
         row("fresh runs forecast within 1.15 of the noise", forecasts) + "\n" +
         (list ? missed + "\n" : "");
}

}  // namespace reeve::bench
