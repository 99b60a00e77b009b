#include "map/opencv/opencv_version.h"

#include <opencv2/core/utility.hpp>

namespace thiessen {

std::string opencv_version() {
  return cv::getVersionString();
}

}  // namespace thiessen
