#include "map/opencv/lone_thread.h"

#include <mutex>
#include <opencv2/core/utility.hpp>

namespace thiessen {

void draw_on_one_thread() {
  static std::once_flag once;
  std::call_once(once, [] { cv::setNumThreads(1); });
}

}  // namespace thiessen
