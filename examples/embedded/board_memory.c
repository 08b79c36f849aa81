/*
 * examples/embedded/board_memory.c - the four functions that a compiler may call in a freestanding program, and the linker
 * script's view of flash and stack.
 */
#include "embedded/board.h"

#include <stddef.h>

#define STACK_PATTERN 0xa5a5a5a5u

extern uint32_t board_stack_limit[], board_stack_top[];
extern const char board_flash_begin[], board_flash_end[], board_data_begin[], board_data_end[];

void *memcpy(void *to, const void *from, size_t bytes);
void *memmove(void *to, const void *from, size_t bytes);
void *memset(void *to, int value, size_t bytes);
int memcmp(const void *a, const void *b, size_t bytes);

void *memcpy(void *to, const void *from, size_t bytes)
{
	unsigned char *t = to;
	const unsigned char *f = from;
	while (bytes-- > 0)
		*t++ = *f++;
	return to;
}

void *memmove(void *to, const void *from, size_t bytes)
{
	unsigned char *t = to;
	const unsigned char *f = from;
	if (t <= f)
		return memcpy(to, from, bytes);
	while (bytes-- > 0)
		t[bytes] = f[bytes];
	return to;
}

void *memset(void *to, int value, size_t bytes)
{
	unsigned char *t = to;
	while (bytes-- > 0)
		*t++ = (unsigned char)value;
	return to;
}

int memcmp(const void *a, const void *b, size_t bytes)
{
	const unsigned char *x = a, *y = b;
	for (; bytes > 0; --bytes, ++x, ++y)
		if (*x != *y)
			return *x < *y ? -1 : 1;
	return 0;
}

uint32_t board_flash_bytes(void)
{
	return (uint32_t)(board_flash_end - board_flash_begin) + (uint32_t)(board_data_end - board_data_begin);
}

void board_stack_paint(void)
{
	uint32_t *word = (uint32_t *)__builtin_frame_address(0) - 64;
	while (word > board_stack_limit)
		*--word = STACK_PATTERN;
}

uint32_t board_stack_bytes(void)
{
	const uint32_t *word = board_stack_limit;
	while (word < board_stack_top && *word == STACK_PATTERN)
		++word;
	return (uint32_t)((const char *)board_stack_top - (const char *)word);
}
