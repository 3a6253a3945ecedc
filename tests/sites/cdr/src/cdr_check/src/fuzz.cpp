#include <cstdlib>
#include <cstring>
#include <new>
#include <random>
#include <stdexcept>

#include "cdr_check.hpp"

namespace
{
std::size_t allocated = 0;
}

void * operator new(std::size_t size)
{
  allocated += size;
  return std::malloc(size ? size : 1);
}
void * operator new[](std::size_t size) {return operator new(size);}
void operator delete(void * memory) noexcept {std::free(memory);}
void operator delete(void * memory, std::size_t) noexcept {std::free(memory);}
void operator delete[](void * memory) noexcept {std::free(memory);}
void operator delete[](void * memory, std::size_t) noexcept {std::free(memory);}

namespace
{

constexpr std::size_t kAfter = 64;

/// What reading `bytes` gives when the memory behind them holds `behind`.
Bytes outcome(const MessageMembers & type, const Bytes & bytes, std::uint8_t behind)
{
  Bytes memory(bytes.size() + kAfter, behind);
  std::memcpy(memory.data(), bytes.data(), bytes.size());
  Message message(type);
  const std::size_t before = allocated;
  const bool ok = message.read(memory.data(), bytes.size());
  // Texts and sequences take some times their size on the wire, and vectors grow by doubling.
  if (allocated - before > 32 * bytes.size() + 1024) {
    throw std::runtime_error(
      std::to_string(bytes.size()) + " bytes made it allocate " +
      std::to_string(allocated - before));
  }
  return ok ? message.write() : Bytes();
}

Bytes variation(const Bytes & valid, std::mt19937 & random)
{
  Bytes bytes = valid;
  const auto any = [&random](std::size_t limit) {return random() % limit;};
  switch (any(4)) {
    case 0:  // cut short
      bytes.resize(any(bytes.size() + 1));
      break;
    case 1:  // some bytes changed
      for (auto count = 1 + any(8); count; --count) {
        bytes[any(bytes.size())] = static_cast<std::uint8_t>(random());
      }
      break;
    case 2:  // a large number where a length may be
      for (auto count = 1 + any(3); bytes.size() >= 8 && count; --count) {
        const std::uint32_t lengths[] = {
          0xffffffff, 0x7fffffff, 0x40000000, 0x20000001, 256,
          static_cast<std::uint32_t>(bytes.size()), static_cast<std::uint32_t>(bytes.size() / 2)};
        std::memcpy(&bytes[4 + 4 * any((bytes.size() - 4) / 4)], &lengths[any(7)], 4);
      }
      break;
    default:  // nothing but noise, behind a valid header
      for (std::size_t i = 4; i < bytes.size(); ++i) {
        bytes[i] = static_cast<std::uint8_t>(any(3) ? any(4) : random());
      }
  }
  return bytes;
}

}  // namespace

std::string fuzz(
  const MessageMembers & type, const Bytes & valid, std::uint32_t seed, unsigned count)
{
  std::mt19937 random(seed);
  unsigned accepted = 0;
  for (unsigned i = 0; i < count; ++i) {
    const Bytes bytes = variation(valid, random);
    const Bytes first = outcome(type, bytes, 0);
    if (first != outcome(type, bytes, 0xff)) {
      throw std::runtime_error("it read beyond the end of its input");
    }
    accepted += !first.empty();
  }
  return std::to_string(accepted) + " of " + std::to_string(count) + " accepted";
}
