#include "map/opencv/drawing_errors.h"

#include <new>
#include <opencv2/core.hpp>

#include "base/error.h"

namespace thiessen {

void throw_drawing_error(const Wording& memory_hint) {
  try {
    throw;
  } catch (const cv::Exception& error) {
    if (error.code == cv::Error::StsNoMem)
      throw Error(Message{{}, 0, "not enough memory to draw the picture", memory_hint});
    throw Error(Message{{}, 0, "the picture could not be drawn: " + error.err, {}});
  } catch (const std::bad_alloc&) {
    throw Error(Message{{}, 0, "not enough memory to draw the picture", memory_hint});
  }
}

}  // namespace thiessen
