#include "cli/checks/plane_report.h"

#include "files/plane/plane_choice.h"

namespace thiessen::cli {

std::string describe_plane(const Inputs& inputs) {
  const auto& error = inputs.plane_error();
  if (!error) return "";
  const StudyFiles& study = inputs.study();
  std::string text = "plane: ";
  if (study.plane) {
    text += study.plane->plane.proj_text() + ", in which lengths are off by up to " +
            percent_text(study.plane->scale_error);
  } else {
    text += printable(study.crs->name());
  }
  return text + "\nplane against the Earth: " + sentence_of(*error, inputs.whole()) + "\n";
}

}  // namespace thiessen::cli
