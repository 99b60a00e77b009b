#include "map/plot/tessellation_picture.h"

#include <new>
#include <opencv2/core.hpp>

#include "base/error.h"
#include "map/ink/encoding.h"
#include "map/plot/plane_plot.h"
#include "map/plot/space_view.h"

namespace thiessen {
namespace {

template <typename Plot>
std::vector<unsigned char> picture_of(Plot&& plot) {
  try {
    Canvas canvas = plot();
    return encoded(canvas, PictureFormat::png);
  } catch (const cv::Exception& error) {
    throw Error(Message{{}, 0, "the picture could not be drawn: " + error.err, {}});
  } catch (const std::bad_alloc&) {
    throw Error(Message{{}, 0, "not enough memory to draw the picture", {}});
  }
}

}  // namespace

std::vector<unsigned char> plane_picture(const Tessellation<2>& tessellation,
                                         const NumberOf& number_of) {
  return picture_of([&] { return plot_plane(tessellation, number_of); });
}

std::vector<unsigned char> space_picture(const Tessellation<3>& tessellation,
                                         const NumberOf& number_of,
                                         const std::optional<View>& view) {
  return picture_of([&] { return view_space(tessellation, number_of, view); });
}

}  // namespace thiessen
