/*
 * examples/demo/gif.h - animated GIF (CompuServe, GIF89a specification, 1990).
 *
 * All frames share one palette of at most 255 colours. A frame holds only the rectangle that changed
 * since the one before, with unchanged pixels in it transparent, which is what keeps files small.
 */
#ifndef CAIRN_DEMO_GIF_H
#define CAIRN_DEMO_GIF_H

#include <stdint.h>
#include <stdio.h>

typedef struct gif {
	FILE *file;
	int32_t width;
	int32_t height;
	int32_t delay_cs;   /* between frames, in hundredths of a second */
	int32_t frames;
	uint8_t *previous;  /* pixels of the last frame */
	uint8_t *scratch;   /* pixels of the changed rectangle */
	int32_t failed;
} gif;

/* rgb: count <= 255 colours of 3 bytes. 0 when the file or memory is not to be had. */
int32_t gif_open(gif *g, const char *path, int32_t width, int32_t height, const uint8_t *rgb, int32_t count, int32_t delay_cs);
void gif_add(gif *g, const uint8_t *pixels);
/* Bytes written, or -1 if anything failed. */
long gif_close(gif *g);

#endif
