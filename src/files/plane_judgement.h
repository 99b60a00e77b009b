#pragma once

#include <optional>

#include "files/study_files.h"
#include "study/plane_error.h"

namespace thiessen {

/// Compares the weights of a study of a plane with those on the Earth, and warns where a weight
/// changes by more than PlaneError::change_to_warn_of, or an area is off by more than
/// PlaneError::area_to_warn_of. Nothing for a geodesic study and for a plane without a CRS, and,
/// with a warning that says why, where the coordinates cannot be taken to the Earth. `study` is
/// made of `files`. Cost: see error_of_plane and study_on_earth.
std::optional<PlaneError> judge_plane(const StudyFiles& files, const Study& study, unsigned threads,
                                      Warnings& warnings);

}  // namespace thiessen
