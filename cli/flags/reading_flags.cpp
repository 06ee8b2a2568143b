#include "cli/flags/reading_flags.hpp"

#include "cli/inputs.hpp"

namespace reeve::cli {

void ReadingFlags::add_columns_to(CLI::App& command, CLI::Option* data) {
  CLI::Option* map =
      command
          .add_option("--map", map_,
                      "A column and its meaning, such as 'Kraft Motor=motor_tension_N'; may be "
                      "repeated")
          ->allow_extra_args(false);
  CLI::Option* unit =
      command
          .add_option("--unit", units_,
                      "Unit of all tensions, such as lbf, or of one column, such as T1=kgf; may be "
                      "repeated")
          ->allow_extra_args(false);
  if (data == nullptr) return;
  map->needs(data);
  unit->needs(data);
}

void ReadingFlags::add_to(CLI::App& command, CLI::Option* data) {
  add_columns_to(command, data);
  group_.add(command, "--group",
             "A column whose texts group the rows, such as a winch or an operator");
  if (data != nullptr) group_.option->needs(data);
}

void ReadingFlags::add_noise_to(CLI::App& command) {
  command
      .add_option("--noise", noise_,
                  "Known standard deviation of a column, such as T1=2%, motor=0.5N or "
                  "T1=2%+0.3N; may be repeated")
      ->allow_extra_args(false);
  command
      .add_option("--exact", exact_,
                  "A column of tensions without scatter, such as a dead weight's; may be "
                  "repeated")
      ->allow_extra_args(false);
}

MeasuredData ReadingFlags::read(const std::string& file, const Catalogue& catalogue) const {
  return read_measured_data(
      file, [&](const std::string& text) { return read_routing(text, catalogue); }, options());
}

ReadingOptions ReadingFlags::options() const {
  ReadingOptions result;
  result.map_option = "--map";
  if (group_.option != nullptr) result.group_option = "--group";
  result.unit_option = "--unit";
  for (const std::string& text : map_) {
    result.map.push_back(for_option("--map", [&] { return parse_column_meaning(text); }));
  }
  for (const std::string& text : units_) {
    result.units.push_back(for_option("--unit", [&] { return parse_column_unit(text); }));
  }
  for (const std::string& text : noise_) {
    result.noise.push_back(for_option("--noise", [&] { return parse_column_noise(text); }));
  }
  for (const std::string& column : exact_) result.noise.push_back({column, {}});
  if (group_.is_given()) result.group = group_.text;
  return result;
}

}  // namespace reeve::cli
