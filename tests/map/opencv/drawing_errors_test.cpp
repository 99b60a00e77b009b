#include "map/opencv/drawing_errors.h"

#include <gtest/gtest.h>

#include <new>
#include <opencv2/core.hpp>
#include <stdexcept>

#include "base/complaints.h"

namespace thiessen {
namespace {

template <typename Thrown>
void draw_and_throw(const Thrown& thrown, const std::string& memory_hint) {
  try {
    throw thrown;
  } catch (...) {
    throw_drawing_error(memory_hint);
  }
}

TEST(DrawingErrors, tell_of_a_lack_of_memory_with_the_hint) {
  EXPECT_EQ(complaint_of([] { draw_and_throw(std::bad_alloc(), "draw less"); }),
            "not enough memory to draw the picture | draw less");
  EXPECT_EQ(complaint_of([] { draw_and_throw(std::bad_alloc(), ""); }),
            "not enough memory to draw the picture");
}

TEST(DrawingErrors, know_a_lack_of_memory_that_opencv_tells) {
  EXPECT_EQ(complaint_of([] {
              draw_and_throw(cv::Exception(cv::Error::StsNoMem, "Failed to allocate", "", "", 0),
                             "draw less");
            }),
            "not enough memory to draw the picture | draw less");
}

TEST(DrawingErrors, pass_on_what_is_not_theirs) {
  EXPECT_THROW(draw_and_throw(std::logic_error("a fault"), ""), std::logic_error);
  EXPECT_EQ(complaint_of([] {
              draw_and_throw(Error(Message{"f", 3, "is odd", ""}), "");
            }),
            "f:3: is odd");
}

}  // namespace
}  // namespace thiessen
