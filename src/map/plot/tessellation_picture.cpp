#include "map/plot/tessellation_picture.h"

#include <string>

#include "base/version.h"
#include "map/opencv/drawing_errors.h"
#include "map/opencv/encoding.h"
#include "map/plot/plane_plot.h"
#include "map/plot/space_view.h"

namespace thiessen {
namespace {

template <typename Plot>
std::vector<unsigned char> picture_of(const PlotSize& size, ImageEncoder encoder, Plot&& plot) {
  try {
    PixelCanvas canvas = plot();
    return encoded(canvas, ImageFormat::png, encoder,
                   {{"software", std::string("thiessen ") + version()}}, size.dots_to_the_inch);
  } catch (...) {
    throw_drawing_error();
  }
}

}  // namespace

std::vector<unsigned char> plane_picture(const Tessellation<2>& tessellation,
                                         const NumberOf& number_of, ImageEncoder encoder,
                                         const std::optional<PlaneWindow>& window,
                                         const PlotSize& size) {
  return picture_of(size, encoder,
                    [&] { return plot_plane(tessellation, number_of, window, size); });
}

std::vector<unsigned char> space_picture(const Tessellation<3>& tessellation,
                                         const NumberOf& number_of, ImageEncoder encoder,
                                         const std::optional<View>& view, const PlotSize& size) {
  return picture_of(size, encoder, [&] { return view_space(tessellation, number_of, view, size); });
}

}  // namespace thiessen
