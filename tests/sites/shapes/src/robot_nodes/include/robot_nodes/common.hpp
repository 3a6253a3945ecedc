#pragma once

#include <string>

std::string greeting(int wheels);

extern "C" unsigned checksum(const char * text, unsigned size);
