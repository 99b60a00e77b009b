#include "files/geopackage_copy.h"

#include <sqlite3.h>
#include <sys/stat.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <fstream>
#include <string_view>
#include <thread>
#include <utility>

#include "base/error.h"
#include "base/interrupt.h"

namespace thiessen {
namespace {

struct CloseDatabase {
  void operator()(sqlite3* database) const { sqlite3_close_v2(database); }
};
using Database = std::unique_ptr<sqlite3, CloseDatabase>;

struct FreeBytes {
  void operator()(unsigned char* bytes) const { sqlite3_free(bytes); }
};

bool is_busy(int status) {
  return status == SQLITE_BUSY || status == SQLITE_LOCKED;
}

/// So long a change by another program is waited for.
constexpr std::chrono::seconds patience(10);

[[noreturn]] void refuse(const std::string& path, int status) {
  const bool busy = is_busy(status);
  throw Error(Message{
      path, 0,
      busy ? "cannot be replaced: another program is using it, and goes on for more than " +
                 std::to_string(patience.count()) + " seconds"
           : "its other layers cannot be kept: " + std::string(sqlite3_errstr(status)),
      busy ? "close it there, or give the output another name" : "give the output another name"});
}

void require(int status, const std::string& path) {
  if (status != SQLITE_OK && status != SQLITE_DONE) refuse(path, status & 0xFF);
}

Database open(const std::string& path, const std::string& name, int flags) {
  sqlite3* opened = nullptr;
  const int status = sqlite3_open_v2(name.c_str(), &opened, flags, nullptr);
  Database database(opened);
  require(status, path);
  return database;
}

/// Whether a journal or log holds changes: what SQLite has done with begins with zeros.
bool holds_changes(const std::string& path) {
  std::array<char, 8> bytes = {};
  std::ifstream file(path, std::ios::binary);
  file.read(bytes.data(), bytes.size());
  return file.gcount() > 0 &&
         std::any_of(bytes.begin(), bytes.end(), [](char c) { return c != '\0'; });
}

/// Requires that no other program is within a change of the file, or has it open in the mode in
/// which changes stand in a log beside it.
void require_no_journal(const std::string& path) {
  for (const char* suffix : {"-wal", "-journal"}) {
    if (!holds_changes(path + suffix)) continue;
    throw Error(Message{path, 0,
                        "cannot be replaced: " + path + suffix +
                            " holds changes of another program that has it open",
                        "close it there, or give the output another name"});
  }
}

bool is_sqlite(const std::string& path) {
  constexpr std::string_view magic = "SQLite format 3";
  std::array<char, magic.size()> bytes = {};
  std::ifstream file(path, std::ios::binary);
  file.read(bytes.data(), bytes.size());
  return file && std::string_view(bytes.data(), bytes.size()) == magic;
}

/// Which file stands at a path: another one once an output has been renamed to it.
std::pair<dev_t, ino_t> file_at(const std::string& path) {
  struct stat status = {};
  if (::stat(path.c_str(), &status) != 0) return {};
  return {status.st_dev, status.st_ino};
}

/// Opens the database, locked against the changes of others. Another run of this program holds its
/// lock until it puts a new file in the old one's place: that is waited for, and then the new file
/// is the one to lock.
Database open_locked(const std::string& path, const std::string& name) {
  using Clock = std::chrono::steady_clock;
  constexpr std::chrono::milliseconds pause(20);
  const auto until = Clock::now() + patience;
  for (;;) {
    throw_if_interrupted();
    const auto file = file_at(path);
    Database database = open(path, name, SQLITE_OPEN_READWRITE);
    const int status =
        sqlite3_exec(database.get(), "BEGIN IMMEDIATE", nullptr, nullptr, nullptr) & 0xFF;
    if (!is_busy(status) || Clock::now() >= until) {
      // Nobody else can write to a file that its owner may not write to.
      if (status != SQLITE_READONLY) require(status, path);
      if (file_at(path) == file) return database;
    } else {
      std::this_thread::sleep_for(pause);
    }
  }
}

}  // namespace

struct GeoPackageCopy::Lock {
  Database database;
};

GeoPackageCopy::GeoPackageCopy(const std::string& path) : lock_(std::make_unique<Lock>()) {
  require_no_journal(path);
  const std::string name = path.starts_with('/') ? path : "./" + path;
  lock_->database = open_locked(path, name);
  const Database source = open(path, name, SQLITE_OPEN_READONLY);
  const Database copy = open(path, ":memory:", SQLITE_OPEN_READWRITE);
  sqlite3_backup* backup = sqlite3_backup_init(copy.get(), "main", source.get(), "main");
  if (backup == nullptr) refuse(path, sqlite3_errcode(copy.get()));
  constexpr int all_pages = -1;
  const int status = sqlite3_backup_step(backup, all_pages);
  sqlite3_backup_finish(backup);
  require(status, path);
  sqlite3_int64 size = 0;
  const std::unique_ptr<unsigned char, FreeBytes> bytes(
      sqlite3_serialize(copy.get(), "main", &size, 0));
  if (!bytes) refuse(path, SQLITE_NOMEM);
  bytes_.assign(reinterpret_cast<const char*>(bytes.get()), static_cast<std::size_t>(size));
}

GeoPackageCopy::~GeoPackageCopy() = default;

std::unique_ptr<GeoPackageCopy> copy_of_geopackage(const std::string& path) {
  if (is_sqlite(path)) return std::make_unique<GeoPackageCopy>(path);
  require_no_journal(path);
  return nullptr;
}

}  // namespace thiessen
