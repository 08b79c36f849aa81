/* examples/testbed/font.h - a bitmap font of one width. */
#ifndef CAIRN_TESTBED_FONT_H
#define CAIRN_TESTBED_FONT_H

#include <stdint.h>

#define FONT_FIRST 32
#define FONT_COUNT 95
#define FONT_WIDTH 7
#define FONT_HEIGHT 13

extern const uint8_t font_rows[FONT_COUNT][FONT_HEIGHT];

#endif
