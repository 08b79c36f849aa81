/*
 * examples/demo/png.h - a still picture: PNG (ISO/IEC 15948) with a palette and stored, that is not
 * compressed, data.
 */
#ifndef CAIRN_DEMO_PNG_H
#define CAIRN_DEMO_PNG_H

#include <stdint.h>

/* pixels: one palette entry each, rows from the top. 0 when the file cannot be written. */
int32_t png_write(const char *path, int32_t width, int32_t height, const uint8_t *pixels, const uint8_t *rgb, int32_t count);

#endif
