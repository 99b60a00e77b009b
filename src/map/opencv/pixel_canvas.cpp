#include "map/opencv/pixel_canvas.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>
#include <utility>

#include "base/interrupt.h"
#include "map/ink/dashes.h"
#include "map/ink/ink.h"
#include "map/opencv/area_filling.h"
#include "map/opencv/fine_grid.h"
#include "map/opencv/halo.h"
#include "map/opencv/line_drawing.h"
#include "map/opencv/lone_thread.h"

namespace thiessen {
namespace {

cv::Mat pixels_of(PixelCanvas& canvas) {
  return {canvas.height(), canvas.width(), CV_8UC3, canvas.bytes().data()};
}

/// The part of a box that lies on the page.
cv::Rect on_page(const PixelBox& box, const Canvas& canvas) {
  return fine::rectangle(box) & cv::Rect(0, 0, canvas.width(), canvas.height());
}

/// The coverage twice over: thin strokes cover half of their pixels, and a rim of half its colour
/// would let dark ground through.
Coverage firm(Coverage coverage) {
  for (std::uint8_t& value : coverage.values)
    value = static_cast<std::uint8_t>(std::min(255, 2 * value));
  return coverage;
}

}  // namespace

PixelCanvas::PixelCanvas(int width, int height)
    : Canvas(width, height),
      bytes_(3 * static_cast<std::size_t>(width) * static_cast<std::size_t>(height), 255) {
  draw_on_one_thread();
}

std::uint64_t PixelCanvas::darkness(const PixelBox& box) {
  const cv::Mat pixels = pixels_of(*this)(on_page(box, *this));
  const cv::Scalar light = cv::sum(pixels);
  const double white = 255.0 * 3 * static_cast<double>(pixels.total());
  return static_cast<std::uint64_t>(white - light[0] - light[1] - light[2]);
}

void PixelCanvas::fill(const PixelBox& box, Colour colour) {
  pixels_of (*this)(on_page(box, *this)).setTo(fine::scalar(colour));
}

void PixelCanvas::border(const PixelBox& box, Colour colour, int thickness) {
  fill({box.x, box.y, box.width, thickness}, colour);
  fill({box.x, box.bottom() - thickness, box.width, thickness}, colour);
  fill({box.x, box.y, thickness, box.height}, colour);
  fill({box.right() - thickness, box.y, thickness, box.height}, colour);
}

void PixelCanvas::draw_disc(Point centre, double radius, Colour colour, const PixelBox& clip,
                            const Mark& /*mark*/) {
  constexpr int fineness = 8;
  const int reach = static_cast<int>(std::ceil(radius)) + 1;
  const PixelBox around{static_cast<int>(std::floor(centre.x)) - reach,
                        static_cast<int>(std::floor(centre.y)) - reach, 2 * reach + 1,
                        2 * reach + 1};
  const cv::Rect box = fine::rectangle(around) & on_page(clip, *this);
  if (box.empty()) return;
  cv::Mat grid(box.size() * fineness, CV_8UC1, cv::Scalar::all(0));
  // The fill takes in the outline, half a fine pixel beyond it.
  const int fine_radius = static_cast<int>(std::lround((radius * fineness - 0.5) * 256));
  const Point corner{static_cast<double>(box.x), static_cast<double>(box.y)};
  cv::circle(grid, fine::place(centre, corner, fineness), std::max(fine_radius, 0),
             cv::Scalar::all(255), cv::FILLED, cv::LINE_8, fine::shift);
  cv::Mat coverage;
  cv::resize(grid, coverage, box.size(), 0, 0, cv::INTER_AREA);
  fine::blend(pixels_of(*this)(box), coverage, colour, 255);
}

void PixelCanvas::areas(std::span<const Area> areas, const Hatch& hatch, const Window& window) {
  const cv::Rect box = on_page(window.box, *this);
  if (box.empty()) return;
  fill_areas(pixels_of(*this)(box), {box.x - window.origin.x, box.y - window.origin.y}, areas,
             hatch);
}

void PixelCanvas::lines(std::span<const Polyline> lines, const Stroke& stroke,
                        const Window& window) {
  const cv::Rect box = on_page(window.box, *this);
  if (box.empty()) return;
  const Point corner{box.x - window.origin.x, box.y - window.origin.y};
  if (stroke.dash <= 0) {
    draw_lines(pixels_of(*this)(box), corner, lines, stroke);
    return;
  }
  std::vector<std::vector<Point>> parts;
  for (const Polyline line : lines) {
    throw_if_interrupted();
    for (std::vector<Point>& part : dashed(line, stroke.dash, stroke.gap)) {
      parts.push_back(std::move(part));
    }
  }
  const std::vector<Polyline> shown(parts.begin(), parts.end());
  draw_lines(pixels_of(*this)(box), corner, shown, stroke);
}

void PixelCanvas::text(const SetText& text, int x, int y, const Lettering& lettering) {
  constexpr int nearly_opaque = 225;
  const int rim = lettering.halo;
  if (rim > 0) blend(x - rim, y - rim, halo(firm(text.ink), rim), ink::white, nearly_opaque);
  blend(x, y, text.ink, lettering.colour, 255);
}

void PixelCanvas::blend(int x, int y, const Coverage& coverage, Colour colour, int alpha) {
  const PixelBox whole{x, y, coverage.width, coverage.height};
  const cv::Rect box = on_page(whole, *this);
  if (box.empty()) return;
  // OpenCV only reads from the coverage, but its interface asks for one that may be written to.
  const cv::Mat covered(coverage.height, coverage.width, CV_8UC1,
                        const_cast<std::uint8_t*>(coverage.values.data()));
  fine::blend(pixels_of(*this)(box), covered(box - cv::Point(x, y)), colour, alpha);
}

}  // namespace thiessen
