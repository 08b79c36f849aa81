/*
 * no_gnu.h - included before a source of the library (-include), makes gcc and clang show it what a compiler without GNU extensions
 * sees: __GNUC__ and __clang__ are not defined, and an attribute is an error. System headers come first, as they need these macros.
 */
#define _POSIX_C_SOURCE 200809L
#include <pthread.h>
#include <sched.h>
#include <float.h>
#include <math.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

#undef __GNUC__
#undef __clang__
#define __attribute__(x) an attribute is a GNU extension
