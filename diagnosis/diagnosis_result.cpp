#include "diagnosis/diagnosis_result.hpp"

namespace reeve::diagnosis {

const char* verdict_name(Verdict verdict) {
  switch (verdict) {
    case Verdict::none:
      return "none";
    case Verdict::cause:
      return "cause";
    case Verdict::unexplained:
      return "unexplained";
    case Verdict::indistinguishable:
      return "indistinguishable";
    case Verdict::too_few:
      return "too_few";
  }
  return "";
}

}  // namespace reeve::diagnosis
