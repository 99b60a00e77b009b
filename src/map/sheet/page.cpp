#include "map/sheet/page.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <string_view>
#include <utility>
#include <vector>

#include "map/ink/unicode.h"

namespace thiessen {
namespace {

// The share of the panel's smaller side that is left free round the study area.
constexpr double rim = 0.04;

/// The part of a text that its first words make up, as many as fit into the room; at least one.
std::string_view words_that_fit(std::string_view text, int size, int room, Typesetter& type) {
  std::size_t end = text.find(' ');
  while (end < text.size()) {
    const std::size_t next = std::min(text.find(' ', end + 1), text.size());
    if (type.set(text.substr(0, next), size, Weight::bold).width() > room) break;
    end = next;
  }
  return text.substr(0, end);
}

/// The first letters of a word, as many as fit into the room; at least one, with its marks.
std::string_view letters_that_fit(std::string_view word, int size, int room, Typesetter& type) {
  std::vector<std::size_t> ends;
  std::size_t end = 0;
  for (const char32_t letter : decoded(word)) {
    if (end > 0 && !is_attached(letter)) ends.push_back(end);
    end += to_utf8({&letter, 1}).size();
  }
  const auto fits = [&](std::size_t length) {
    return type.set(word.substr(0, length), size, Weight::bold).width() <= room;
  };
  const auto beyond = std::partition_point(ends.begin(), ends.end(), fits);
  if (ends.empty()) return word;
  return word.substr(0, beyond == ends.begin() ? ends.front() : *std::prev(beyond));
}

/// The sizes of a head's type, and the distances between its baselines and edges, in ems.
struct HeadSizes {
  double title;
  double title_in_lines;  ///< of a title that has no room on one
  double subtitle;
  double above;
  double rise;  ///< of the title over its baseline
  double below_title;
  double subtitle_rise;
  double below_subtitle;
  double below;
};

HeadSizes sizes_of(Head head) {
  return head == Head::large ? HeadSizes{1.5, 1.2, 1.0, 0.8, 1.3, 0.5, 0.9, 0.4, 0.4}
                             : HeadSizes{1.1, 1.0, 0.8, 0.5, 0.9, 0.3, 0.75, 0.25, 0.3};
}

/// Sets the title on one line, smaller where it is somewhat too long, else on up to three, parted
/// between words, and within one that is wider than the page. What the last has no room for ends in
/// an ellipsis.
std::vector<SetText> title_lines(std::string_view title, const PageStyle& style,
                                 const HeadSizes& sizes, int room, Typesetter& type) {
  constexpr std::size_t most = 3;
  const int size = style.ems(sizes.title_in_lines);
  std::vector<SetText> lines;
  SetText line = type.fit(title, style.ems(sizes.title), size, room, Weight::bold);
  while (line.is_shortened && lines.size() + 1 < most) {
    std::string_view first = words_that_fit(title, size, room, type);
    if (type.set(first, style.em, Weight::bold).width() > room)
      first = letters_that_fit(first, size, room, type);
    if (first.size() == title.size()) break;
    if (!first.empty()) lines.push_back(type.fit(first, size, style.em, room, Weight::bold));
    title.remove_prefix(first.size());
    if (title.starts_with(' ')) title.remove_prefix(1);
    line = type.fit(title, size, size, room, Weight::bold);
  }
  if (line.is_shortened) line = type.fit(title, size, style.em, room, Weight::bold);
  if (line.width() > 0) lines.push_back(std::move(line));
  return lines;
}

/// The height of a panel that is `width` across: it follows the extent's shape where the picture
/// leaves its own height open.
int panel_height(const Picture& picture, const Extent& extent, int width, int least, int others) {
  if (picture.height > 0) return picture.height - others;
  const double wanted = width / panel_aspect(extent);
  const double most =
      std::min<double>(max_picture_side, static_cast<double>(max_picture_pixels) / picture.width) -
      others;
  return static_cast<int>(std::min(std::max(wanted, static_cast<double>(least)), most));
}

Page bare_page(const Picture& picture, const Extent& extent, const PageStyle& style) {
  Page page;
  page.style = style;
  page.width = picture.width;
  page.height = std::max(panel_height(picture, extent, picture.width, 1, 0), min_picture_side);
  page.panel = {0, 0, page.width, page.height};
  return page;
}

}  // namespace

PageStyle page_style(int width, int height, int dots_to_the_inch) {
  constexpr int smallest_em = 11;
  constexpr double largest_em = 10.0 / 72;  // inches
  constexpr double least_em = 9.0 / 72;  // so that names, which are smaller, can be read on paper
  const double tall = height > 0 ? height : 0.75 * width;
  PageStyle style;
  double em = std::sqrt(width * tall) / 60;
  if (dots_to_the_inch > 0) {
    em = std::min(em, largest_em * dots_to_the_inch);
    // But for a heading and a legend there must be room.
    const double room = std::min(width / 26.0, tall / 17.0);
    em = std::max(em, std::min(least_em * dots_to_the_inch, room));
  }
  style.em = std::max(smallest_em, static_cast<int>(std::lround(em)));
  style.hairline = std::max(1, style.ems(0.06));
  constexpr double least_type = 5.0 / 72;  // inches
  style.least_type =
      std::max(style.least_type, static_cast<int>(std::ceil(least_type * dots_to_the_inch)));
  style.bare = width < style.ems(24) || tall < style.ems(16);
  return style;
}

double panel_aspect(const Extent& extent) {
  constexpr double widest = 3;
  constexpr double tallest = 0.6;
  if (extent.height() <= 0) return widest;
  return std::clamp(extent.width() / extent.height(), tallest, widest);
}

int set_head(const std::string& title, const std::string& subtitle, Page& page, Typesetter& type,
             Head head) {
  const PageStyle& style = page.style;
  const HeadSizes sizes = sizes_of(head);
  const int room = page.width - 2 * style.em;
  page.title.clear();
  int y = style.ems(sizes.above);
  for (SetText& text : title_lines(title, style, sizes, room, type)) {
    const int baseline = y + std::max(style.ems(sizes.rise), text.baseline);
    y = baseline + std::max(style.ems(sizes.below_title), text.height() - text.baseline);
    page.title.push_back({std::move(text), baseline});
  }
  page.subtitle = type.fit(subtitle, style.ems(sizes.subtitle), style.ems(0.8), room);
  if (page.subtitle.width() > 0) {
    page.subtitle_baseline = y + std::max(style.ems(sizes.subtitle_rise), page.subtitle.baseline);
    const int descent = page.subtitle.height() - page.subtitle.baseline;
    y = page.subtitle_baseline + std::max(style.ems(sizes.below_subtitle), descent);
  }
  return y + style.ems(sizes.below);
}

Page lay_out(const Picture& picture, const Extent& extent, const Legend& legend, Typesetter& type) {
  const PageStyle style = page_style(picture.width, picture.height, picture.dots_to_the_inch);
  if (style.bare) return bare_page(picture, extent, style);
  Page page;
  page.style = style;
  page.width = picture.width;
  int top = set_head(picture.title, picture.subtitle, page, type);
  const int margin = style.em;
  const int column = legend.width() == 0 ? 0 : legend.width() + margin;
  const int foot = style.ems(3.4);
  const int coordinates = style.ems(1.1);  // their height below the map
  const int left = style.ems(3.4);         // and the room for them beside it
  if (picture.height > 0 && picture.height - top - foot < legend.least_height())
    top = set_head(picture.title, picture.subtitle, page, type, Head::small);
  const int width = picture.width - left - margin - column;
  const int least = std::max(legend.height(), style.ems(9));
  const int height = panel_height(picture, extent, width, least, top + coordinates + foot);
  page.height = top + height + coordinates + foot;
  page.panel = {left, top, width, height};
  // To the right of the map nothing stands beside its coordinates.
  page.legend = {left + width + margin, top, legend.width(), height + coordinates};
  page.footer = {left, top + height + coordinates, width + column, foot};
  return page;
}

PanelTransform::PanelTransform(const Extent& extent, const PixelBox& panel)
    : middle_{extent.west + extent.width() / 2, extent.south + extent.height() / 2},
      centre_{panel.width / 2.0, panel.height / 2.0} {
  const double free = 1 - 2 * rim;
  const double across = extent.width() > 0 ? panel.width * free / extent.width() : HUGE_VAL;
  const double up = extent.height() > 0 ? panel.height * free / extent.height() : HUGE_VAL;
  scale_ = std::min(across, up);
}

}  // namespace thiessen
