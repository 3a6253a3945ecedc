// Lines as Python prints them.
#ifndef TWINS_HPP_
#define TWINS_HPP_

#include <algorithm>
#include <iostream>
#include <string>
#include <vector>

void play_actions();
void play_parameters();
void play_policies();
void play_services();
void play_times();

inline void part(bool value) {std::cout << (value ? "True" : "False");}
inline void part(const std::vector<std::string> & words)
{
  for (std::size_t i = 0; i < words.size(); ++i) {std::cout << (i ? " " : "") << words[i];}
}
template<typename T>
void part(const T & value) {std::cout << value;}

/// Print the parts with spaces between them, as print() does.
template<typename First, typename ... Rest>
void say(const First & first, const Rest & ... rest)
{
  part(first);
  ((std::cout << ' ', part(rest)), ...);
  std::cout << std::endl;
}

#endif  // TWINS_HPP_
