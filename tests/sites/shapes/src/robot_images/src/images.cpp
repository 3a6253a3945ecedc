// Reads and writes images of maps with GraphicsMagick.
#include <GraphicsMagick/Magick++.h>
#include <zlib.h>

#include <cstdint>
#include <cstdio>
#include <exception>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

namespace
{

void print_shades(Magick::Image image)
{
  image.type(Magick::GrayscaleType);
  std::vector<std::uint8_t> shades(image.columns() * image.rows());
  image.write(0, 0, image.columns(), image.rows(), "I", Magick::CharPixel, shades.data());
  for (const int shade : shades) {std::printf("%d ", shade);}
  std::printf("%s\n", image.matte() ? "and some are transparent" : "in all");
}

void attempt(const std::string & path)
{
  try {
    print_shades(Magick::Image(path));
  } catch (const std::exception & error) {
    std::printf("%s\n", error.what());
  }
}

/// A map with one unknown cell, as the mode "scale" of map servers writes it.
void write_map(const std::string & path)
{
  Magick::Image image({2, 1}, "red");
  image.type(Magick::TrueColorMatteType);
  image.depth(8);
  Magick::Color unknown = Magick::ColorGray(0.5);
  unknown.alphaQuantum(TransparentOpacity);
  image.pixelColor(0, 0, unknown);
  image.pixelColor(1, 0, Magick::ColorGray(0.25));
  image.write(path);
}

void spoil(const std::string & path)
{
  std::ifstream file(path, std::ios::binary);
  std::string content{std::istreambuf_iterator<char>(file), {}};
  content.resize(content.find("IDAT") + 6);
  std::ofstream("spoiled.png", std::ios::binary) << content;
}

}  // namespace

int main()
{
  Magick::InitializeMagick(nullptr);
  print_shades(Magick::Image("/ros/share/robot_images/maps/room.pgm"));
  for (const std::string path : {"map.png", "map.bmp", "map.tga"}) {
    write_map(path);
    print_shades(Magick::Image(path));
  }
  spoil("map.png");
  attempt("spoiled.png");
  attempt("gone.pgm");
  try {
    Magick::CoderInfo("jpg");
  } catch (const Magick::ErrorOption & error) {
    std::printf("%s\n", error.what());
  }
  std::printf("Q%d, zlib %s\n", QuantumDepth, zlibVersion());
}
