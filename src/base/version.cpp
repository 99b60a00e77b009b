#include "base/version.h"

namespace thiessen {

const char* version() {
  return THIESSEN_VERSION;
}

}  // namespace thiessen
