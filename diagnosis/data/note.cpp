#include "diagnosis/data/note.hpp"

namespace reeve::diagnosis {

const char* note_kind_name(NoteKind kind) {
  switch (kind) {
    case NoteKind::time_series:
      return "time_series";
    case NoteKind::duplicate:
      return "duplicate";
    case NoteKind::duplicate_across_runs:
      return "duplicate_across_runs";
    case NoteKind::motor_side_above_motor:
      return "motor_side_above_motor";
    case NoteKind::units:
      return "units";
    case NoteKind::covariate:
      return "covariate";
    case NoteKind::comment:
      return "comment";
    case NoteKind::jams:
      return "jams";
    case NoteKind::not_compared:
      return "not_compared";
    case NoteKind::clock:
      return "clock";
    case NoteKind::no_motion:
      return "no_motion";
    case NoteKind::reversed:
      return "reversed";
  }
  return "";
}

}  // namespace reeve::diagnosis
