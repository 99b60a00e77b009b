#pragma once

namespace thiessen {

/// The area of the WGS 84 ellipsoid in square metres: 2 pi a^2 (1 + (1 - e^2) / e artanh e), of
/// which 50 digits were computed.
inline constexpr double earth_area = 510065621724088.509;

}  // namespace thiessen
