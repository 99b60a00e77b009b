#include "gdal/output/fixed_date.h"

#include <cpl_conv.h>

namespace thiessen {

FixedDate::FixedDate() {
  CPLSetThreadLocalConfigOption("OGR_CURRENT_DATE", "1970-01-01T00:00:00.000Z");
}

FixedDate::~FixedDate() {
  CPLSetThreadLocalConfigOption("OGR_CURRENT_DATE", nullptr);
}

}  // namespace thiessen
