#pragma once

#include "files/study_files.h"
#include "rainfall/network/network.h"

namespace thiessen {

/// The stations and basins of a study of a plane as the geodesic metric would have them: WGS 84
/// longitude and latitude, basins with the edges that their file gives them. `network` holds the
/// study's stations. Edges are followed to `chord_error` metres. Requires a study with a CRS.
/// Throws Error where coordinates lie outside the area of their CRS, or cannot be taken to WGS 84.
/// Cost: as that of reading the study without its files.
StudyParts study_on_earth(const StudyFiles& study, const Network& network, double chord_error);

}  // namespace thiessen
