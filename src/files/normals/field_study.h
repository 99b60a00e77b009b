#pragma once

#include <memory>
#include <string>

#include "files/study_files.h"
#include "rainfall/normals/normal_field.h"
#include "study/study.h"

namespace thiessen {

/// The normals of a study by a field of its stations and of its basins, which were read with these
/// (see StationsRequest::normal_field). Throws Error, naming each station and basin whose normals
/// are missing or not above 0, and where only one of the two has them by months.
std::shared_ptr<const NormalField> normals_of_fields(const std::string& field, const Study& study,
                                                     const StudyFiles& files);

}  // namespace thiessen
