#include "gdal/crs/proj_objects.h"

#include <algorithm>
#include <cstddef>
#include <cstdlib>
#include <fstream>
#include <memory>
#include <new>
#include <string>
#include <string_view>

#include "base/error.h"
#include "base/utf8.h"

namespace thiessen {
namespace {

/// The folders that PROJ searches, for a message, as far as the environment names them.
std::string searched_folders() {
  for (const char* name : {"PROJ_DATA", "PROJ_LIB"}) {
    const char* value = std::getenv(name);
    if (value != nullptr && *value != '\0') {
      return std::string(" (") + name + " is " + quoted(value, 80) + ")";
    }
  }
  return {};
}

bool is_sqlite(const std::string& file) {
  constexpr std::string_view mark = "SQLite format 3";
  std::string beginning(mark.size(), '\0');
  std::ifstream(file, std::ios::binary)
      .read(beginning.data(), static_cast<std::streamsize>(mark.size()));
  return beginning == mark;
}

/// Throws Error where the environment adds a database to PROJ's own that is none: PROJ then opens
/// neither.
void require_added_databases() {
  const char* const value = std::getenv("PROJ_AUX_DB");
  for (std::string_view rest = value != nullptr ? value : ""; !rest.empty();) {
    const std::size_t end = std::min(rest.find(':'), rest.size());
    const std::string file(rest.substr(0, end));
    rest.remove_prefix(std::min(end + 1, rest.size()));
    if (is_sqlite(file)) continue;
    throw Error(Message{{},
                        0,
                        "PROJ_AUX_DB names " + quoted(file, 80) +
                            ", which is missing or no database, and PROJ reads none without it",
                        "unset PROJ_AUX_DB: the study needs PROJ's own database alone"});
  }
}

/// Throws std::bad_alloc where no more memory can be had than a database takes to open.
void require_memory() {
  constexpr std::size_t enough = std::size_t{16} << 20;
  const std::unique_ptr<char[]> probe(new char[enough]);
  *const_cast<volatile char*>(probe.get()) = 0;  // or the compiler would leave out both
}

bool database_is_there() {
  const ProjContext context = quiet_context();
  if (proj_context_get_database_metadata(context.get(), "DATABASE.LAYOUT.VERSION.MAJOR") != nullptr)
    return true;
  require_memory();
  require_added_databases();
  return false;
}

}  // namespace

ProjContext quiet_context() {
  ProjContext context(proj_context_create());
  proj_log_level(context.get(), PJ_LOG_NONE);
  proj_context_set_enable_network(context.get(), 0);
  return context;
}

void require_proj_database() {
  static const bool there = database_is_there();
  if (there) return;
  throw Error(Message{{},
                      0,
                      "PROJ's database of coordinate reference systems, proj.db, is missing or "
                      "cannot be read" +
                          searched_folders(),
                      "PROJ_DATA names the folder that holds it; PROJ's own is used where neither "
                      "PROJ_DATA nor PROJ_LIB is set"});
}

}  // namespace thiessen
