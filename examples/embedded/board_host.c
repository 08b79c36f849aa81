/*
 * examples/embedded/board_host.c - the same program on a computer: its hash is that of the boards.
 */
#include "embedded/board.h"

#include <stdio.h>

void board_print(const char *text) { fputs(text, stdout); }
uint32_t board_ticks(void) { return 0; }
uint32_t board_flash_bytes(void) { return 0; }
void board_stack_paint(void) { }
uint32_t board_stack_bytes(void) { return 0; }
