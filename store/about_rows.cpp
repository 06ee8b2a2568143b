#include "store/about_rows.hpp"

#include <SQLiteCpp/Statement.h>
#include <fmt/format.h>

#include <string>
#include <vector>

namespace reeve::store {
namespace {

void write_pairs(SQLite::Database& database, const std::string& table,
                 const std::vector<StoredSetting>& pairs) {
  SQLite::Statement insert(database, fmt::format("INSERT INTO {} VALUES (?, ?)", table));
  for (const StoredSetting& pair : pairs) {
    insert.reset();
    insert.bind(1, pair.key);
    insert.bind(2, pair.value);
    insert.exec();
  }
}

std::string about(SQLite::Database& database, const std::string& key) {
  SQLite::Statement query(database, "SELECT value FROM about WHERE key = ?");
  query.bind(1, key);
  return query.executeStep() ? query.getColumn(0).getString() : "";
}

}  // namespace

void write_about(SQLite::Database& database, const Description& description, Keep keep) {
  write_pairs(database, "about",
              {{"exploration", description.exploration},
               {"version", description.version},
               {"arguments", description.arguments},
               {"keep", keep == Keep::all ? "all" : "best"}});
  write_pairs(database, "settings", description.settings);
}

Description read_description(SQLite::Database& database) {
  Description description{
      about(database, "exploration"), about(database, "version"), about(database, "arguments"), {}};
  SQLite::Statement query(database, "SELECT key, value FROM settings ORDER BY key");
  while (query.executeStep()) {
    description.settings.push_back(
        {query.getColumn(0).getString(), query.getColumn(1).getString()});
  }
  return description;
}

Keep read_keep(SQLite::Database& database) {
  return about(database, "keep") == "all" ? Keep::all : Keep::best;
}

}  // namespace reeve::store
