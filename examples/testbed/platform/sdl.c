/*
 * examples/testbed/platform/sdl.c - the testbed in a window of SDL 2.
 *
 *     testbed [scene]
 *     testbed --picture file.ppm [scene [steps]]     takes steps, writes a picture and prints the hash; needs no display
 */
#include "testbed/testbed.h"
#include <SDL.h>
#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static int32_t picture(testbed *t, const char *path, int32_t steps)
{
	FILE *f = fopen(path, "wb");
	if (f == NULL)
		return 0;
	for (int32_t i = 0; i < steps; ++i)
		testbed_step(t);
	testbed_frame(t, 0.0);
	printf("%s %016" PRIx64 "\n", testbed_at(t->entry).scene->name, testbed_hash(t));
	fprintf(f, "P6 %" PRId32 " %" PRId32 " 255\n", t->canvas.width, t->canvas.height);
	fwrite(t->canvas.rgb, 3, (size_t)t->canvas.width * (size_t)t->canvas.height, f);
	return fclose(f) == 0;
}

static int32_t key_of(SDL_Keycode key)
{
	if (key == SDLK_LEFT || key == SDLK_RIGHT)
		return key == SDLK_LEFT ? '[' : ']';
	return key >= 32 && key < 127 ? (int32_t)key : 0;
}

/* 0 to end. */
static int32_t handle(testbed *t, const SDL_Event *e)
{
	switch (e->type) {
	case SDL_QUIT: return 0;
	case SDL_KEYDOWN: testbed_event(t, TESTBED_KEY, 0.0f, 0.0f, key_of(e->key.keysym.sym)); return e->key.keysym.sym != SDLK_ESCAPE;
	case SDL_MOUSEMOTION: testbed_event(t, TESTBED_MOVE, (float)e->motion.x, (float)e->motion.y, 0); break;
	case SDL_MOUSEBUTTONDOWN: testbed_event(t, TESTBED_PRESS, (float)e->button.x, (float)e->button.y, 0); break;
	case SDL_MOUSEBUTTONUP: testbed_event(t, TESTBED_RELEASE, (float)e->button.x, (float)e->button.y, 0); break;
	case SDL_MOUSEWHEEL: testbed_event(t, TESTBED_WHEEL, t->x, t->y, e->wheel.y); break;
	default: break;
	}
	return 1;
}

/* The texture has the canvas's size; NULL when there is none. */
static SDL_Texture *fit(testbed *t, SDL_Renderer *renderer, SDL_Texture *texture)
{
	int width = 0, height = 0;
	SDL_GetRendererOutputSize(renderer, &width, &height);
	if (texture != NULL && width == t->canvas.width && height == t->canvas.height)
		return texture;
	if (texture != NULL)
		SDL_DestroyTexture(texture);
	if (!testbed_resize(t, width, height))
		return NULL;
	return SDL_CreateTexture(renderer, SDL_PIXELFORMAT_RGB24, SDL_TEXTUREACCESS_STREAMING, t->canvas.width, t->canvas.height);
}

static int32_t run(testbed *t)
{
	if (SDL_Init(SDL_INIT_VIDEO) != 0)
		return 0;
	SDL_Window *window = SDL_CreateWindow("Cairn testbed", SDL_WINDOWPOS_UNDEFINED, SDL_WINDOWPOS_UNDEFINED, 1280, 760, SDL_WINDOW_RESIZABLE);
	SDL_Renderer *renderer = window != NULL ? SDL_CreateRenderer(window, -1, SDL_RENDERER_PRESENTVSYNC) : NULL;
	SDL_Texture *texture = NULL;
	uint64_t before = SDL_GetPerformanceCounter();
	int32_t running = renderer != NULL, good = running;
	while (running) {
		SDL_Event event;
		while (SDL_PollEvent(&event))
			running = running && handle(t, &event);
		uint64_t now = SDL_GetPerformanceCounter();
		texture = fit(t, renderer, texture);
		good = texture != NULL;
		running = running && good;
		if (!good)
			break;
		testbed_frame(t, (double)(now - before) / (double)SDL_GetPerformanceFrequency());
		before = now;
		SDL_UpdateTexture(texture, NULL, t->canvas.rgb, 3 * t->canvas.width);
		SDL_RenderCopy(renderer, texture, NULL, NULL);
		SDL_RenderPresent(renderer);
	}
	SDL_Quit();
	return good;
}

int main(int argc, char **argv)
{
	static testbed t;
	int32_t pictured = argc > 2 && strcmp(argv[1], "--picture") == 0, first = pictured ? 3 : 1, good;
	if (!testbed_open(&t, 1280, 760))
		return 1;
	if (argc > first && testbed_find(argv[first]) < 0) {
		fprintf(stderr, "there is no scene named %s\n", argv[first]);
		return 2;
	}
	if (argc > first)
		testbed_select(&t, testbed_find(argv[first]));
	good = pictured ? picture(&t, argv[2], argc > 4 ? atoi(argv[4]) : 120) : run(&t);
	if (!good)
		fprintf(stderr, "testbed: %s\n", pictured ? "cannot write the picture" : SDL_GetError());
	testbed_close(&t);
	return !good;
}
