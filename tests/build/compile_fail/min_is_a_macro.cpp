// error: quell and the standard library call min and max: define NOMINMAX before windows.h
#ifndef CORRECT
#define min(a, b) (((a) < (b)) ? (a) : (b))
#define max(a, b) (((a) > (b)) ? (a) : (b))
#endif
#include <quell/quell.hpp>

int main() {}
