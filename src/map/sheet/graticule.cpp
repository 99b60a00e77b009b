#include "map/sheet/graticule.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "map/ink/ink.h"
#include "map/sheet/ticks.h"

namespace thiessen {
namespace {

constexpr double half_turn = 180;

/// The step of at least `least`: 1, 2 or 5 times a power of ten; of degrees above 10 it is 30, 60
/// or 90.
RoundValue step_from(double least, FrameAxis axis) {
  constexpr double ten = 10;
  constexpr double thirty = 30;
  constexpr double sixty = 60;
  if (axis != FrameAxis::plane && least > ten) {
    return {least <= thirty ? 3 : least <= sixty ? 6 : 9, 1};
  }
  const RoundValue step = round_below(least);
  if (step.value() >= least) return step;
  if (step.digits == 5) return {1, step.exponent + 1};
  return {step.digits == 1 ? 2 : 5, step.exponent};
}

/// `count` steps as a decimal number, with as many decimals as the step has.
std::string text_of(long long count, const RoundValue& step) {
  std::string text = decimal_text(count * step.digits, step.exponent);
  if (step.exponent >= 0 || text.find('e') != std::string::npos) return text;
  const std::size_t point = text.find('.');
  const std::size_t decimals = point == std::string::npos ? 0 : text.size() - point - 1;
  if (point == std::string::npos) text += '.';
  return text + std::string(static_cast<std::size_t>(-step.exponent) - decimals, '0');
}

std::string name_of(long long count, const RoundValue& step, FrameAxis axis) {
  if (axis == FrameAxis::plane) return text_of(count, step);
  if (axis == FrameAxis::longitude) {
    const long long turn = std::llround(2 * half_turn / step.value());
    const bool whole = std::abs(static_cast<double>(turn) * step.value() - 2 * half_turn) < 1e-9;
    while (whole && 2 * count > turn) count -= turn;
    while (whole && 2 * count <= -turn) count += turn;
  }
  const char* side =
      axis == FrameAxis::longitude ? (count < 0 ? " W" : " E") : (count < 0 ? " S" : " N");
  const bool middle =
      count == 0 || std::abs(static_cast<double>(count) * step.value()) == half_turn;
  return text_of(std::abs(count), step) + "°" + (middle ? "" : side);
}

/// The values at equal distances along an edge, in which a whole turn between two is no step.
std::vector<double> samples(const std::function<double(double)>& value, double length,
                            std::size_t count, FrameAxis axis) {
  std::vector<double> values;
  for (std::size_t i = 0; i <= count; ++i) {
    double next = value(length * static_cast<double>(i) / static_cast<double>(count));
    if (axis == FrameAxis::longitude && !values.empty()) {
      next = values.back() + std::remainder(next - values.back(), 2 * half_turn);
    }
    values.push_back(next);
  }
  return values;
}

using Coordinate = std::function<double(double)>;

// Where a number has no room, its mark is left out too, for it would say nothing.
void draw_lower(Canvas& canvas, const Page& page, const Coordinate& value, FrameAxis axis,
                Typesetter& type) {
  const PageStyle& style = page.style;
  const PixelBox& panel = page.panel;
  const int size = std::max(style.least_type, style.ems(0.6));
  const int length = std::max(2, style.ems(0.25));
  int free_from = panel.x - style.em;
  for (const FrameTick& tick :
       frame_ticks(value, panel.width, std::max(1, panel.width / style.ems(3.3)), axis)) {
    const int x = panel.x + static_cast<int>(tick.at);
    const SetText text = type.set(tick.text, size);
    const int left = x - text.width() / 2;
    if (left < free_from || left + text.width() > panel.right() + style.em) continue;
    canvas.fill({x, panel.bottom(), style.hairline, length}, ink::border);
    canvas.text(text, left, panel.bottom() + length + style.ems(0.15), {ink::quiet_text});
    free_from = left + text.width() + style.ems(0.5);
  }
}

void draw_left(Canvas& canvas, const Page& page, const Coordinate& value, FrameAxis axis,
               Typesetter& type) {
  const PageStyle& style = page.style;
  const PixelBox& panel = page.panel;
  const int size = std::max(style.least_type, style.ems(0.6));
  const int length = std::max(2, style.ems(0.25));
  int free_below = panel.bottom() + style.em;
  for (const FrameTick& tick :
       frame_ticks(value, panel.height, std::max(1, panel.height / style.ems(3.5)), axis)) {
    const int y = panel.bottom() - 1 - static_cast<int>(tick.at);
    const int room = panel.x - length - style.ems(0.4);
    const SetText text = type.fit(tick.text, size, size * 3 / 4, room);
    const int top = y - text.height() / 2;
    if (text.width() == 0 || top + text.height() > free_below) continue;
    canvas.fill({panel.x - length, y, length, style.hairline}, ink::border);
    canvas.text(text, panel.x - length - style.ems(0.2) - text.width(), top, {ink::quiet_text});
    free_below = top - style.ems(0.3);
  }
}

}  // namespace

std::vector<FrameTick> frame_ticks(const std::function<double(double)>& value, double length,
                                   int most, FrameAxis axis) {
  constexpr std::size_t pieces = 256;
  const std::vector<double> values = samples(value, length, pieces, axis);
  const auto [low, high] = std::minmax_element(values.begin(), values.end());
  if (!std::isfinite(*high - *low) || !(*high > *low) || most < 1) return {};
  const RoundValue step = step_from((*high - *low) / most, axis);
  constexpr double most_steps = 1e15;
  if (std::max(std::abs(*low), std::abs(*high)) / step.value() > most_steps) return {};
  std::vector<FrameTick> ticks;
  for (std::size_t i = 0; i < pieces; ++i) {
    const double a = values[i] / step.value();
    const double b = values[i + 1] / step.value();
    const double first = std::ceil(std::min(a, b));
    for (double count = first; count < std::max(a, b); ++count) {
      const double share = (count - a) / (b - a);
      ticks.push_back({(static_cast<double>(i) + share) * length / static_cast<double>(pieces),
                       name_of(std::llround(count), step, axis)});
    }
  }
  return ticks;
}

void draw_graticule(Canvas& canvas, const Page& page, const StudyView& view,
                    const PanelTransform& transform, const FrameEdges& edges, Typesetter& type) {
  const bool plane = view.projection.kind() == MapProjection::Kind::plane;
  const int height = page.panel.height;
  const auto study = [&](double x, double y) {
    return view.projection.inverse(transform.inverse({x, y}));
  };
  const Group group(canvas, {"graticule"});
  if (edges.lower) {
    draw_lower(
        canvas, page, [&](double x) { return study(x, height).x; },
        plane ? FrameAxis::plane : FrameAxis::longitude, type);
  }
  if (edges.left) {
    draw_left(
        canvas, page, [&](double y) { return study(0, height - y).y; },
        plane ? FrameAxis::plane : FrameAxis::latitude, type);
  }
}

}  // namespace thiessen
