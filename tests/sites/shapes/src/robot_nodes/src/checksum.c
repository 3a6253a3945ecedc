unsigned checksum(const char * text, unsigned size);

unsigned checksum(const char * text, unsigned size)
{
  unsigned sum = 0;
  for (unsigned i = 0; i < size; ++i) {
    sum += (unsigned char)text[i];
  }
  return sum;
}
