#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "base/error.h"
#include "gdal/crs/crs.h"
#include "gdal/output/encoded_file.h"
#include "gdal/output/isohyet_lines.h"
#include "results/provenance.h"

namespace thiessen {

/// Encodes isohyets as a layer `isohyets` with the fields `basin` and `rainfall`, in the format of
/// `path`'s extension: GeoJSON in WGS 84 (RFC 7946), where the CRS is known, or any vector format
/// that GDAL writes. `basin_ids` are by basin. `older` holds the bytes of a GeoPackage whose other
/// layers are kept; it is empty where there is none. Throws Error where there is no such format,
/// and where it cannot hold them.
std::vector<EncodedFile> isohyets_file(std::span<const Isohyet> isohyets,
                                       std::span<const std::string> basin_ids,
                                       const std::optional<Crs>& crs, const Provenance& made_by,
                                       const std::string& path, const std::string& older,
                                       Warnings& warnings);

}  // namespace thiessen
