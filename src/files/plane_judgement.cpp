#include "files/plane_judgement.h"

#include "files/plane/plane_choice.h"
#include "files/study_on_earth.h"

namespace thiessen {
namespace {

Wording plane_text(const StudyFiles& files) {
  if (files.plane) return "in the plane made for the study ";
  return "in the plane of " + files.crs->name() + " ";
}

}  // namespace

std::optional<PlaneError> judge_plane(const StudyFiles& files, const Study& study, unsigned threads,
                                      Warnings& warnings) {
  if (files.metric != Metric::planar || !files.crs) return std::nullopt;
  std::optional<PlaneError> error;
  try {
    error = error_of_plane(
        study, study_on_earth(files, study.network(), Yardstick::measuring_tolerance), threads);
  } catch (const Error& fault) {
    warnings.add({files.stations_file, 0,
                  "how far a plane's weights are from those on the Earth cannot be told: " +
                      fault.messages().front().text,
                  ""});
    return std::nullopt;
  }
  if (error->moves_weights() || error->distorts_areas()) {
    // Degrees taken as a plane have been warned of with this hint before.
    Wording hint;
    if (!files.crs->geographic()) hint = setting("metric", "geodesic") + " measures the Earth";
    if (!hint.empty() && !files.plane)
      hint += ", and " + setting("plane", automatic_plane) + " finds the plane that distorts least";
    warnings.add({{}, 0, plane_text(files) + sentence_of(*error, study), hint});
  }
  return error;
}

}  // namespace thiessen
