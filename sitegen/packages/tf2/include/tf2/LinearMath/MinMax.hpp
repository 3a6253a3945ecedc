#pragma once

#include <algorithm>

template<class T>
const T & tf2Min(const T & a, const T & b) {return a < b ? a : b;}
template<class T>
const T & tf2Max(const T & a, const T & b) {return a > b ? a : b;}
template<class T>
const T & GEN_clamped(const T & a, const T & low, const T & high)
{
  return a < low ? low : (high < a ? high : a);
}
template<class T>
void tf2SetMin(T & a, const T & b) {a = tf2Min(a, b);}
template<class T>
void tf2SetMax(T & a, const T & b) {a = tf2Max(a, b);}
template<class T>
void GEN_clamp(T & a, const T & low, const T & high) {a = GEN_clamped(a, low, high);}
