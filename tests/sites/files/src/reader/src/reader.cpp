// Opens files that packages install to share/, by their paths.
#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <string>
#include <thread>
#include <vector>

#include "rclcpp/rclcpp.hpp"

namespace fs = std::filesystem;

const fs::path kShare = "/ros/share";

std::string content(const fs::path & path)
{
  std::ifstream file(path);
  if (!file) {return std::string("cannot open: ") + std::strerror(errno);}
  std::string line;
  std::getline(file, line);
  return line;
}

int main(int argc, char ** argv)
{
  rclcpp::init(argc, argv);
  auto node = std::make_shared<rclcpp::Node>("reader");
  const fs::path map = node->declare_parameter("map", "");

  std::vector<std::string> names;
  for (const auto & entry : fs::directory_iterator(map.parent_path())) {
    names.push_back(entry.path().filename().string() + " " + std::to_string(entry.file_size()));
  }
  std::sort(names.begin(), names.end());
  for (const auto & name : names) {std::cout << name << '\n';}

  // Each of the two waits for the same file.
  std::string heard;
  std::thread other([&] {heard = content(map);});
  std::cout << content(map) << '\n';
  other.join();
  std::cout << heard << '\n';

  std::cout << "empty: '" << content(map.parent_path() / "empty.txt") << "'\n";
  fs::current_path(kShare / "reader");
  std::cout << content("config/../config/limits.yaml") << '\n';
  std::cout << content(kShare / "rooms" / "attic.txt") << '\n';
  std::cout << content(map.parent_path() / "panel.js") << '\n';

  const auto manifest = kShare / "reader" / "package.xml";
  std::cout << content(manifest) << '\n';
  std::ofstream(manifest) << "replaced\n";
  std::cout << content(manifest) << '\n';
  std::ofstream("config/limits.yaml", std::ios::app) << "speed: 2.0\n";
  std::ifstream limits("config/limits.yaml");
  std::cout << std::string(std::istreambuf_iterator<char>(limits), {});
  std::cout << std::getenv("DOOR") << '\n';
  std::cout << "done" << std::endl;
}
