// In what order readings were taken: by the clock where every row has one, else as the file has
// them. A clock may begin again with each run; runs then follow one another as in the file.
#pragma once

#include "diagnosis/data/measured_data.hpp"

namespace reeve::diagnosis {

// Reading::taken of each.
void set_taken(MeasuredData& data);

}  // namespace reeve::diagnosis
