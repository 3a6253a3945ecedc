// Reads what is typed in all the ways that programs do: by streams, as a password, key by key.
#include <fcntl.h>
#include <poll.h>
#include <sys/select.h>
#include <termios.h>
#include <unistd.h>

#include <cstdio>
#include <iostream>
#include <string>
#include <thread>

#include "rclcpp/rclcpp.hpp"

int main(int argc, char ** argv)
{
  rclcpp::init(argc, argv);
  auto node = std::make_shared<rclcpp::Node>("compiled");
  rclcpp::TimerBase::SharedPtr timer = node->create_wall_timer(
    std::chrono::milliseconds(20), [&] {
      std::puts("meanwhile");
      timer->cancel();
    });
  std::thread spinning([&] {rclcpp::spin(node);});

  std::string name;
  int number = 0;
  std::cout << "name? " << std::flush;
  std::getline(std::cin, name);
  std::cout << "hello " << name << "\nnumber? " << std::flush;
  std::cin >> number;
  std::cin.ignore();
  std::cout << "twice " << 2 * number << std::endl;

  termios before;
  tcgetattr(STDIN_FILENO, &before);
  termios hidden = before;
  hidden.c_lflag &= ~ECHO;
  tcsetattr(STDIN_FILENO, TCSANOW, &hidden);
  char letters[100];
  char * word = std::fgets(letters, sizeof letters, stdin);
  std::printf("a secret of %zu\n", word ? std::string(word).size() - 1 : 0);

  termios keys = before;
  keys.c_lflag &= ~(ICANON | ECHO);
  tcsetattr(STDIN_FILENO, TCSANOW, &keys);
  pollfd file{STDIN_FILENO, POLLIN, 0};
  std::printf("%d before any key\n", poll(&file, 1, 20));
  std::string pressed;
  while (pressed != "q") {
    fd_set files;
    FD_ZERO(&files);
    FD_SET(STDIN_FILENO, &files);
    const int ready = select(STDIN_FILENO + 1, &files, nullptr, nullptr, nullptr);
    char bytes[8];
    const ssize_t size = read(STDIN_FILENO, bytes, sizeof bytes);
    pressed.assign(bytes, size);
    std::printf("%d key", ready);
    for (const unsigned char byte : pressed) {std::printf(" %d", byte);}
    std::puts("");
  }
  fcntl(STDIN_FILENO, F_SETFL, O_NONBLOCK);
  char none;
  std::printf("%zd when nobody waits\n", read(STDIN_FILENO, &none, 1));
  fcntl(STDIN_FILENO, F_SETFL, 0);

  tcsetattr(STDIN_FILENO, TCSANOW, &before);
  while (std::getline(std::cin, name)) {std::cout << "line " << name << std::endl;}
  std::puts("the end");
  rclcpp::shutdown();
  spinning.join();
}
