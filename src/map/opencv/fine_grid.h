#pragma once

#include <opencv2/core.hpp>
#include <span>
#include <vector>

#include "map/ink/canvas.h"

/// OpenCV draws on a grid finer than the picture's pixels, and the mean of the fine pixels is what
/// a pixel shows: so edges are smooth, and areas that share an edge leave no seam.
namespace thiessen::fine {

/// The fraction's bits of the whole numbers in which OpenCV takes coordinates.
inline constexpr int shift = 8;

/// A place on a grid `fineness` times as fine. `origin` is the place of the grid's upper left, in
/// pixels. OpenCV counts from the middle of the first pixel.
cv::Point place(Point p, Point origin, int fineness);

/// A part of a line or of a ring: its points on the fine grid. Points closer together than a third
/// of a pixel are passed over, but for the last.
std::vector<cv::Point> places(std::span<const Point> points, Point origin, int fineness);

/// The rows of pixels that may be drawn on at once, so that a grid of `bytes_per_pixel` takes a few
/// megabytes however large the picture is.
int rows_at_once(int width, int fineness, int bytes_per_pixel);

cv::Rect rectangle(const PixelBox& box);
cv::Scalar scalar(Colour colour);

/// Mixes a colour into pixels, each weighted by its coverage and by `alpha` / 255.
void blend(cv::Mat pixels, const cv::Mat& coverage, Colour colour, int alpha);

}  // namespace thiessen::fine
