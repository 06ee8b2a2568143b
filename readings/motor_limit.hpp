// Motor tensions at the end of their sensor's range. There the motor pulls more than is recorded,
// and by how much, only the strands say.
//
// The greatest recorded motor tension is such an end if what the strands carry of it differs from
// row to row at least three times as much as at smaller ones, between rows that are alike but for
// the load.
#pragma once

#include "readings/measured_data.hpp"

namespace reeve::readings {

// Takes the motor tension off these rows, and notes it.
void free_motor_tensions_at_their_limit(MeasuredData& data);

}  // namespace reeve::readings
