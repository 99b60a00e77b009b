#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "gdal/layers/opening.h"

class OGRLayer;

namespace thiessen {

/// Requires a file to be as long as it says itself, before GDAL reads what is there of it: the
/// parts of shapefiles, FlatGeobuf, GeoPackage. Of other formats a part cannot be read (XML, JSON,
/// zip), or nothing is known of their length. What is odd but no error goes to `oddities`. Throws
/// Error with the numbers that disagree.
void require_whole(const std::string& file, const Opening& opening,
                   std::vector<std::string>& oddities);

/// How many features a layer declares, so that those read can be held against it. Nothing where the
/// number says nothing: of a database that others write to meanwhile, of KML, whose layers count
/// what is no placemark, and of a shapefile, which counts deleted records.
std::optional<std::uint64_t> declared_features(OGRLayer& layer, const Opening& opening);

}  // namespace thiessen
