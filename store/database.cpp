#include "store/database.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sqlite3.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <limits>
#include <new>

#include "core/error.hpp"
#include "store/schema.hpp"

namespace reeve::store {
namespace {

// Beyond all that SQLite locks, and beyond the end of any file.
constexpr off_t locked_byte = off_t{1} << 62;

namespace fs = std::filesystem;

std::string reason(const SQLite::Exception& error) {
  switch (error.getErrorCode()) {
    case SQLITE_NOTADB:
      return "it is no SQLite database";
    case SQLITE_CORRUPT:
      return "it is damaged or cut off";
    case SQLITE_BUSY:
    case SQLITE_LOCKED:
      return "another process is using it";
    case SQLITE_READONLY:
    case SQLITE_PERM:
      return "it cannot be written";
    case SQLITE_CANTOPEN:
      return "it cannot be opened";
    case SQLITE_FULL:
    case SQLITE_IOERR:
      return "it cannot be written further; it holds what was stored before";
    default:
      return "SQLite cannot use it";
  }
}

int pragma(const SQLite::Database& database, const char* name) {
  SQLite::Statement query(database, fmt::format("PRAGMA {}", name));
  return query.executeStep() ? query.getColumn(0).getInt() : 0;
}

bool is_empty(const SQLite::Database& database) {
  SQLite::Statement query(database, "SELECT count(*) FROM sqlite_master");
  return query.executeStep() && query.getColumn(0).getInt() == 0;
}

[[noreturn]] void refuse(const fs::path& file, const std::string& what,
                         const std::string& expected) {
  throw InputError(
      {.where = file.string(), .what = what, .expected = expected, .form = InputForm::unknown});
}

// A read or a write for which SQLite has no memory is another error to it.
bool is_of_memory(const SQLite::Exception& error) {
  return error.getErrorCode() == SQLITE_NOMEM || error.getExtendedErrorCode() == SQLITE_IOERR_NOMEM;
}

// Names such as ":memory:" mean something to SQLite, absolute ones do not.
SQLite::Database database_in(const fs::path& file, int flags) {
  return {fs::absolute(file).string(), flags, patience_ms};
}

// If a killed process left a half-written transaction, the next process to open the file rolls it
// back. This requires write access.
SQLite::Database readable_database(const fs::path& file) {
  for (const int flags : {SQLite::OPEN_READONLY, SQLite::OPEN_READWRITE}) {
    try {
      SQLite::Database database = database_in(file, flags);
      pragma(database, "application_id");
      return database;
    } catch (const SQLite::Exception& error) {
      if (error.getErrorCode() != SQLITE_READONLY) throw;
    }
  }
  refuse(file, "a process that was killed has left it half written",
         "a place where that can be undone, by writing");
}

// SQLite waits without end for a pipe that it takes for its log.
void require_plain_neighbours(const fs::path& file) {
  for (const char* ending : {"-journal", "-wal", "-shm"}) {
    const fs::path neighbour = file.string() + ending;
    std::error_code ignored;
    const fs::file_status status = fs::status(neighbour, ignored);
    if (!fs::exists(status) || fs::is_regular_file(status)) continue;
    refuse(file, fmt::format("'{}' beside it is no file", neighbour.filename().string()),
           "a file of SQLite's, or none");
  }
}

// True if there is a file. Refuses what SQLite would say less of, wait for without end (a pipe) or
// write to (a device).
bool is_there(const fs::path& file, Access access) {
  if (file.empty()) refuse("''", "it is no name", "that of a file");
  std::error_code error;
  switch (fs::status(file, error).type()) {
    case fs::file_type::regular:
      require_plain_neighbours(file);
      return true;
    case fs::file_type::directory:
      refuse(file, "it is a folder", "the file of a store");
    case fs::file_type::none:
      require_memory(error);
      throw InputError({.where = file.string(), .what = "it cannot be opened: " + error.message()});
    case fs::file_type::not_found:
      break;
    default:
      refuse(file, "it is a device or a pipe", "the file of a store");
  }
  if (access == Access::read) refuse(file, "there is no such file", "what reeve explore stored");
  const fs::path folder = file.parent_path();
  if (folder.empty() || fs::is_directory(folder, error)) return false;
  refuse(file, fmt::format("there is no folder '{}'", folder.string()), "one that is there");
}

}  // namespace

WriterLock::WriterLock(const std::filesystem::path& file)
    : descriptor_(::open(file.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0644)) {
  if (descriptor_ < 0) return;
  struct flock lock = {};
  lock.l_type = F_WRLCK;
  lock.l_whence = SEEK_SET;
  lock.l_start = locked_byte;
  lock.l_len = 1;
  if (::fcntl(descriptor_, F_OFD_SETLK, &lock) == 0) return;
  if (errno != EAGAIN && errno != EACCES) return;
  ::close(descriptor_);
  throw InputError({.where = file.string(), .what = "another process is writing it"});
}

WriterLock::~WriterLock() {
  if (descriptor_ >= 0) ::close(descriptor_);
}

bool WriterLock::is_on(const std::filesystem::path& file) const {
  struct stat locked = {};
  if (descriptor_ < 0 || ::fstat(descriptor_, &locked) != 0) return true;
  struct stat named = {};
  return ::stat(file.c_str(), &named) == 0 && named.st_dev == locked.st_dev &&
         named.st_ino == locked.st_ino;
}

void fail(const fs::path& file, const SQLite::Exception& error) {
  if (is_of_memory(error)) throw std::bad_alloc();
  throw InputError(
      {.where = file.string(), .what = fmt::format("{} ({})", reason(error), error.getErrorStr())});
}

std::optional<SQLite::Database> open_store(const fs::path& file, Access access) {
  if (!is_there(file, access)) return std::nullopt;
  return in_database(file, [&]() -> std::optional<SQLite::Database> {
    SQLite::Database database = readable_database(file);
    // SQLite takes a file shorter than a page of its own for an empty one, and writes over it.
    if (fs::file_size(file) > 0 && pragma(database, "page_count") == 0) {
      throw SQLite::Exception("file is not a database", SQLITE_NOTADB);
    }
    const int application = pragma(database, "application_id");
    const int version = pragma(database, "user_version");
    if (application == 0 && version == 0 && is_empty(database)) {
      if (access == Access::write) return std::nullopt;
      refuse(file, "explore has saved nothing in it yet", "what it stored");
    }
    if (application != application_id) {
      refuse(file, "it is a database, but no store of an exploration", "what reeve explore stored");
    }
    if (version != schema_version) {
      refuse(file, fmt::format("it is a store of version {}", version),
             fmt::format("version {}, which this program reads", schema_version));
    }
    if (!has_tables(database)) {
      refuse(file, "its tables are not those of a store: it is damaged, or was changed",
             "what reeve explore stored");
    }
    return database;
  });
}

void require_sound(SQLite::Database& database) {
  SQLite::Statement query(database, "PRAGMA quick_check(1)");
  const std::string found = query.executeStep() ? query.getColumn(0).getString() : "";
  if (found != "ok") throw SQLite::Exception(found, SQLITE_CORRUPT);
}

SQLite::Database open_to_write(const fs::path& file) {
  return database_in(file, SQLite::OPEN_READWRITE);
}

std::int64_t whole_number(std::uint64_t number) {
  if (number <= static_cast<std::uint64_t>(std::numeric_limits<std::int64_t>::max())) {
    return static_cast<std::int64_t>(number);
  }
  throw InputError(fmt::format("{} routings are more than a store can number", number));
}

}  // namespace reeve::store
