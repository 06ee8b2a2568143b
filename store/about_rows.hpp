// Of which exploration a store is and what it keeps, as rows.
#pragma once

#include <SQLiteCpp/Database.h>

#include "store/description.hpp"
#include "store/exploration_store.hpp"

namespace reeve::store {

void write_about(SQLite::Database& database, const Description& description, Keep keep);

// Without names of known routings and texts of constraints, which stand with their counts.
Description read_description(SQLite::Database& database);
Keep read_keep(SQLite::Database& database);

}  // namespace reeve::store
