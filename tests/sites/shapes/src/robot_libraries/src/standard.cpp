// Names what g++'s <functional> and <iomanip> include.
#include <functional>
#include <iomanip>

std::string listed()
{
  std::vector<int> values{3, 1, 2};
  std::sort(values.begin(), values.end(), std::less<int>());
  std::ostringstream text;
  for (const int value : values) {
    text << std::setw(value > 1 ? 2 : 1) << value;
  }
  return text.str();
}
