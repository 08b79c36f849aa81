/* The functions of memory that Cairn calls: board_memory.c, or a toolchain's own. */
#ifndef FREESTANDING_STRING_H
#define FREESTANDING_STRING_H

#include <stddef.h>

void *memcpy(void *to, const void *from, size_t bytes);
void *memmove(void *to, const void *from, size_t bytes);
void *memset(void *to, int value, size_t bytes);
int memcmp(const void *a, const void *b, size_t bytes);

/* As few instructions in place where the number of bytes is a small constant. */
#define memcpy __builtin_memcpy
#define memset __builtin_memset

#endif
