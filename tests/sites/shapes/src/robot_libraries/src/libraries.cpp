// Uses libraries of which it needs only the headers.
#include <boost/algorithm/string.hpp>
#include <boost/signals2.hpp>
#include <eigen3/Eigen/Core>
#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <spdlog/spdlog.h>

#include <cstdio>
#include <string>

std::string listed();
void print_compiled();

int main()
{
  std::string text = "  Boost trims ";
  boost::trim(text);
  int heard = 0;
  boost::signals2::signal<void()> signal;
  signal.connect([&heard] {++heard;});
  signal.connect([&heard] {++heard;});
  signal();
  std::printf("%s and %d listen\n", text.c_str(), heard);
  std::printf("%s\n", nlohmann::json{{"kind", "json"}}.dump().c_str());
  std::printf("%s\n", fmt::format("fmt has {} words", 3).c_str());
  const auto level = spdlog::level::to_string_view(spdlog::level::warn);
  std::printf("spdlog has level %s\n", fmt::format("{}", level).c_str());
  std::printf("Eigen has %d\n", Eigen::Vector3i(1, 2, 3).sum());
  std::printf("g++ includes %s\n", listed().c_str());
  print_compiled();
}
