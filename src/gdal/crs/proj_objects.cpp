#include "gdal/crs/proj_objects.h"

#include <cstdlib>
#include <string>

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

bool database_is_there() {
  const ProjContext context = quiet_context();
  return proj_context_get_database_metadata(context.get(), "DATABASE.LAYOUT.VERSION.MAJOR") !=
         nullptr;
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
