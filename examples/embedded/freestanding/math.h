/* The functions of numbers that Cairn calls, as instructions of the processor (-fno-math-errno). */
#ifndef FREESTANDING_MATH_H
#define FREESTANDING_MATH_H

#define fabsf __builtin_fabsf
#define sqrtf __builtin_sqrtf
#define sqrt __builtin_sqrt
#define INFINITY __builtin_inff()

#endif
