#include "earth/geographiclib_version.h"

#include <GeographicLib/Config.h>

namespace thiessen {

const char* geographiclib_version() {
  return GEOGRAPHICLIB_VERSION_STRING;
}

}  // namespace thiessen
