#pragma once

#include <vector>

#include "map/ink/canvas.h"
#include "map/plot/camera.h"
#include "map/plot/scene_vector.h"

namespace thiessen {

/// How a line in space is drawn where it is nearest.
struct Pen {
  Colour colour;
  double width = 1;  ///< in pixels
  double dash = 0;   ///< in pixels; 0: solid
  double gap = 0;
  double casing = 0;  ///< pixels on either side in which what is behind is interrupted
};

/// Lines and balls in space, drawn from the farthest to the nearest, far ones fainter and thinner.
class DepthDrawing {
 public:
  DepthDrawing(const Camera& camera, const PixelBox& panel) : camera_(camera), panel_(panel) {}

  /// A part of a line, or a ball (from == to), in pixels of the page, as it will be drawn.
  struct Piece {
    double ahead = 0;
    Point from;
    Point to;
    double width = 0;
    double casing = 0;
    Colour colour;
    bool is_ball = false;
  };

  /// Adds what of the line lies ahead and in the panel, in pieces: its dashes, or parts so short
  /// that each has one depth. Cost: the pieces, which the panel's size bounds.
  void add_line(const SceneVector& from, const SceneVector& to, const Pen& pen);
  /// `radius` in units of the scene; in pixels it is kept between the other two.
  void add_ball(const SceneVector& centre, double radius, double least, double largest,
                Colour colour);

  /// The pieces, from the farthest to the nearest, equally far ones by their places.
  const std::vector<Piece>& in_order();
  /// Draws into the panel alone.
  void draw(Canvas& canvas);

  /// From 0 near where the box begins to 1 near where it ends.
  double depth(double ahead) const;
  /// The colour, fainter the farther.
  Colour faded(Colour colour, double ahead) const;

 private:
  void draw_line(Canvas& canvas, const Piece& piece) const;
  void draw_ball(Canvas& canvas, const Piece& piece) const;

  const Camera& camera_;
  PixelBox panel_;
  std::vector<Piece> pieces_;
};

}  // namespace thiessen
