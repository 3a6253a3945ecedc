// The image on which turtles draw; coordinates are in metres from its lower left corner.
#pragma once

#include <cstdint>
#include <vector>

struct Point
{
  double x;
  double y;
};

struct Rgb
{
  std::uint8_t r;
  std::uint8_t g;
  std::uint8_t b;
};

class Canvas
{
public:
  static constexpr int SIZE = 500;
  static constexpr double PIXELS_PER_METER = 45;
  // The coordinate of the last pixel (m).
  static constexpr double EXTENT = (SIZE - 1) / PIXELS_PER_METER;

  void fill(Rgb color);
  // A line with round ends; `width` is in pixels.
  void line(Point from, Point to, int width, Rgb color);
  Rgb at(Point point) const;

private:
  std::vector<Rgb> pixels_ = std::vector<Rgb>(SIZE * SIZE);
};
