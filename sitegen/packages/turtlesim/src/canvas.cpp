#include "canvas.hpp"

#include <algorithm>
#include <cmath>

namespace
{
// In pixels, with y downwards.
Point on_image(Point point)
{
  return {
    point.x * Canvas::PIXELS_PER_METER, (Canvas::EXTENT - point.y) * Canvas::PIXELS_PER_METER};
}

int within(double pixel)
{
  return static_cast<int>(std::clamp(std::round(pixel), 0.0, Canvas::SIZE - 1.0));
}

double distance_to_line(Point point, Point from, Point to)
{
  const double x = to.x - from.x;
  const double y = to.y - from.y;
  const double square = x * x + y * y;
  const double along = square > 0 ? ((point.x - from.x) * x + (point.y - from.y) * y) / square : 0;
  const double nearest = std::clamp(along, 0.0, 1.0);
  return std::hypot(from.x + nearest * x - point.x, from.y + nearest * y - point.y);
}
}  // namespace

void Canvas::fill(Rgb color)
{
  std::fill(pixels_.begin(), pixels_.end(), color);
}

void Canvas::line(Point from, Point to, int width, Rgb color)
{
  const Point a = on_image(from);
  const Point b = on_image(to);
  // The pixels that a line goes through are its own, however thin it is.
  const double reach = std::max(width / 2.0, 0.5);
  const auto [left, right] = std::minmax(a.x, b.x);
  const auto [top, bottom] = std::minmax(a.y, b.y);
  for (int y = within(top - reach); y <= within(bottom + reach); ++y) {
    for (int x = within(left - reach); x <= within(right + reach); ++x) {
      const Point pixel{static_cast<double>(x), static_cast<double>(y)};
      if (distance_to_line(pixel, a, b) <= reach) {pixels_[y * SIZE + x] = color;}
    }
  }
}

Rgb Canvas::at(Point point) const
{
  const Point pixel = on_image(point);
  return pixels_[within(pixel.y) * SIZE + within(pixel.x)];
}
