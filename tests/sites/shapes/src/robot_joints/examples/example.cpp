#include <motors_of_this_robot.h>

int main() {return turn_all_motors();}
