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

}  // namespace

std::string page_file(const Page& page, const Picture& picture, PictureFormat format,
                      const std::function<void(Canvas&)>& draw) {
  if (format == PictureFormat::svg) {
    SvgCanvas canvas(page.width, page.height);
    draw(canvas);
    return canvas.document(picture.title, description_of(picture), picture.dots_to_the_inch);
  }
  PixelCanvas canvas(page.width, page.height);
  draw(canvas);
  const bool png = format == PictureFormat::png;
  const auto file = encoded(canvas, png ? PixelFormat::png : PixelFormat::jpeg, picture.tags,
                            picture.dots_to_the_inch);
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
