/* examples/testbed/platform/web.c - the testbed as a WebAssembly module: testbed.js calls these functions and shows the pixels. */
#include "testbed/testbed.h"
#include <stdlib.h>

#define EXPORT __attribute__((visibility("default"), used))

static testbed bed;
static uint32_t *pixels; /* red, green, blue, opaque: what a canvas takes */

EXPORT int32_t web_resize(int32_t width, int32_t height)
{
	free(pixels);
	pixels = NULL;
	if (!testbed_resize(&bed, width, height))
		return 0;
	pixels = (uint32_t *)malloc((size_t)bed.canvas.width * (size_t)bed.canvas.height * 4);
	return pixels != NULL;
}

EXPORT int32_t web_open(int32_t width, int32_t height) { return testbed_open(&bed, width, height) && web_resize(width, height); }
EXPORT int32_t web_width(void) { return bed.canvas.width; }
EXPORT int32_t web_height(void) { return bed.canvas.height; }
EXPORT void web_event(int32_t kind, float x, float y, int32_t code) { testbed_event(&bed, kind, x, y, code); }
EXPORT void web_select(int32_t entry) { testbed_select(&bed, entry); }
EXPORT int32_t web_count(void) { return testbed_count(); }
EXPORT const char *web_name(int32_t entry) { return testbed_at(entry).scene->name; }
EXPORT uint64_t web_hash(void) { return testbed_hash(&bed); }
EXPORT int32_t web_steps(void) { return bed.run.step_index; }

/* Widgets of the panel as drawn in the last frame; the middle of one is x * 65536 + y. */
EXPORT int32_t web_widgets(void) { return bed.widget_count; }
EXPORT const char *web_widget_name(int32_t index) { return bed.widgets[index].name; }
EXPORT int32_t web_widget_at(int32_t index)
{
	const testbed_widget *w = &bed.widgets[index];
	return (int32_t)(w->x + 0.5f * w->width) * 65536 + (int32_t)(w->y + 0.5f * w->height);
}

EXPORT const uint32_t *web_frame(double elapsed_s)
{
	testbed_frame(&bed, elapsed_s);
	const int32_t count = bed.canvas.width * bed.canvas.height;
	const uint8_t *rgb = bed.canvas.rgb;
	for (int32_t i = 0; i < count; ++i, rgb += 3)
		pixels[i] = 0xFF000000u | (uint32_t)rgb[2] << 16 | (uint32_t)rgb[1] << 8 | rgb[0];
	return pixels;
}
