#pragma once

#include <string>
#include <string_view>

namespace thiessen {

/// A unit that UDUNITS writes with powers, in quotients, as rain_unit reads it: `mm h-1` is `mm/h`,
/// and `kg m^-2 s**-1` is `kg/m2/s`. Any other text stays as it is.
std::string udunits_with_quotients(std::string_view unit);

}  // namespace thiessen
