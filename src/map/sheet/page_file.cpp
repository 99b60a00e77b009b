#include "map/sheet/page_file.h"

#include "map/ink/ink.h"
#include "map/opencv/encoding.h"
#include "map/opencv/pixel_canvas.h"
#include "map/svg/svg_canvas.h"

namespace thiessen {
namespace {

/// What the picture's tags say, on one line.
std::string description_of(const Picture& picture) {
  std::string text;
  for (const auto& [name, value] : picture.tags) {
    text += (text.empty() ? "" : "; ") + (name == "software" ? value : name + ": " + value);
  }
  return text;
}

/// The page on paper: as it was asked for in millimetres, else by its pixels and their density.
PaperSize paper_of(const Page& page, const Picture& picture) {
  constexpr double millimetres_to_the_inch = 25.4;
  const double dots = picture.dots_to_the_inch;
  if (dots <= 0) return {};
  const auto side = [&](double asked, int pixels) {
    return asked > 0 ? asked : pixels * millimetres_to_the_inch / dots;
  };
  return {side(picture.paper.width, page.width), side(picture.paper.height, page.height)};
}

}  // namespace

std::string page_file(const Page& page, const Picture& picture, PictureFormat format,
                      ImageEncoder encoder, const std::function<void(Canvas&)>& draw) {
  if (format == PictureFormat::svg) {
    SvgCanvas canvas(page.width, page.height);
    draw(canvas);
    return canvas.document(picture.title, description_of(picture), paper_of(page, picture));
  }
  PixelCanvas canvas(page.width, page.height);
  draw(canvas);
  const bool png = format == PictureFormat::png;
  const auto file = encoded(canvas, png ? ImageFormat::png : ImageFormat::jpeg, encoder,
                            picture.tags, picture.dots_to_the_inch);
  return {file.begin(), file.end()};
}

void draw_head(Canvas& canvas, const Page& page) {
  for (const TitleLine& line : page.title) {
    canvas.text(line.text, page.style.em, line.baseline - line.text.baseline,
                {ink::text, 0, {"title"}});
  }
  canvas.text(page.subtitle, page.style.em, page.subtitle_baseline - page.subtitle.baseline,
              {ink::quiet_text, 0, {"subtitle"}});
}

}  // namespace thiessen
