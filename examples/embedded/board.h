/*
 * examples/embedded/board.h - what the example needs of a board: text output, a counter, and measures of flash and stack.
 */
#ifndef EXAMPLES_EMBEDDED_BOARD_H
#define EXAMPLES_EMBEDDED_BOARD_H

#include <stdint.h>

/* board_ticks counts upwards in the bits of the mask. */
#ifdef __arm__ /* SysTick, 25 MHz; the emulator executes one instruction a nanosecond */
#define BOARD_TICKS_MASK 0xffffffu
#define BOARD_INSTRUCTIONS_A_TICK 40u
#else
#define BOARD_TICKS_MASK 0xffffffffu
#define BOARD_INSTRUCTIONS_A_TICK 1u
#endif

void board_print(const char *text);
uint32_t board_ticks(void);
uint32_t board_flash_bytes(void);
/* Fills the unused stack with a pattern; then how much of it was overwritten. */
void board_stack_paint(void);
uint32_t board_stack_bytes(void);

#endif
