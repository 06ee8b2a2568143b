#include "readings/note.hpp"

namespace reeve::readings {

const char* note_kind_name(NoteKind kind) {
  switch (kind) {
    case NoteKind::time_series:
      return "time_series";
    case NoteKind::duplicate:
      return "duplicate";
    case NoteKind::duplicate_across_runs:
      return "duplicate_across_runs";
    case NoteKind::equal_by_chance:
      return "equal_by_chance";
    case NoteKind::motor_side_above_motor:
      return "motor_side_above_motor";
    case NoteKind::units:
      return "units";
    case NoteKind::covariate:
      return "covariate";
    case NoteKind::comment:
      return "comment";
    case NoteKind::column_names:
      return "column_names";
    case NoteKind::passed_over:
      return "passed_over";
    case NoteKind::tare:
      return "tare";
    case NoteKind::known_noise:
      return "known_noise";
    case NoteKind::assumed:
      return "assumed";
    case NoteKind::not_as_pulled:
      return "not_as_pulled";
    case NoteKind::letters:
      return "letters";
    case NoteKind::outlier:
      return "outlier";
    case NoteKind::below_zero:
      return "below_zero";
    case NoteKind::jams:
      return "jams";
    case NoteKind::not_compared:
      return "not_compared";
    case NoteKind::clock:
      return "clock";
    case NoteKind::no_direction:
      return "no_direction";
    case NoteKind::no_motion:
      return "no_motion";
    case NoteKind::groups_differ:
      return "groups_differ";
    case NoteKind::runs_of_groups:
      return "runs_of_groups";
    case NoteKind::inverted:
      return "inverted";
    case NoteKind::outlier_forecast:
      return "far_forecast";
    case NoteKind::other_direction:
      return "other_direction";
    case NoteKind::outlier_groups:
      return "far_together";
    case NoteKind::not_following:
      return "not_following";
    case NoteKind::reversed:
      return "reversed";
    case NoteKind::against_motion:
      return "against_motion";
    case NoteKind::sparse:
      return "sparse";
  }
  return "";
}

}  // namespace reeve::readings
