#pragma once

namespace thiessen {

/// Tells where the CRS of a file is known from.
enum class CrsOrigin {
  none,     ///< not known
  implied,  ///< GeoJSON without a `crs` member: WGS 84 by RFC 7946
  columns,  ///< columns named lon and lat, or alike: WGS 84
  file,     ///< the file names it
  object,   ///< it stands with coordinates that a caller hands in
  lent,     ///< the file names none, and that of the other file is taken
  option    ///< the command line names it
};

}  // namespace thiessen
