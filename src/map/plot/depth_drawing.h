#pragma once

#include <vector>

#include "map/ink/canvas.h"
#include "map/plot/camera.h"
#include "map/plot/scene_vector.h"

namespace thiessen {

/// The look of a line in space at the place where it is nearest.
struct Pen {
  Colour colour;
  double width = 1;  ///< in pixels
  double dash = 0;   ///< in pixels; 0: solid
  double gap = 0;
  double casing = 0;  ///< pixels on either side in which lines behind are interrupted
};

/// Draws lines and balls in space from the farthest to the nearest, far ones fainter and thinner,
/// so that near ones cover those behind.
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

  /// Adds the part of a line that lies ahead and in the panel, in pieces: its dashes, or parts so
  /// short that each has one depth. Cost: the pieces, whose number the panel's size bounds.
  void add_line(const SceneVector& from, const SceneVector& to, const Pen& pen);
  /// Adds a ball. `radius` is in units of the scene; in pixels it is kept between `least` and
  /// `largest`.
  void add_ball(const SceneVector& centre, double radius, double least, double largest,
                Colour colour);

  /// The pieces from the farthest to the nearest; equally far ones are ordered by their places, so
  /// that the order in which they were added does not matter.
  const std::vector<Piece>& in_order();
  /// Draws all pieces, inside the panel only.
  void draw(Canvas& canvas);

  /// The depth of a distance ahead: from 0 near the beginning of the box to 1 near its end.
  double depth(double ahead) const;
  /// The colour at a distance ahead: the farther, the fainter.
  Colour faded(Colour colour, double ahead) const;

 private:
  void draw_line(Canvas& canvas, const Piece& piece) const;
  void draw_ball(Canvas& canvas, const Piece& piece) const;

  const Camera& camera_;
  PixelBox panel_;
  std::vector<Piece> pieces_;
};

}  // namespace thiessen
