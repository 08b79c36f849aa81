/*
 * test/fuzz/fuzz_recording.c - playing any bytes as a recording: bad ones end the playing, whatever they say.
 */
#include "fuzz.h"

#include "record/player.h"

void fuzz_recording(const uint8_t *bytes, size_t count)
{
	player p;
	int32_t k;
	uint8_t *own = (uint8_t *)malloc(count + 8);
	FUZZ_REQUIRE(own != NULL);
	memcpy(own, "CairnRec", 8);
	if (count > 0)
		memcpy(own + 8, bytes, count);
	if (player_open(&p, NULL, own, count + 8)) {
		for (k = 0; k < 20 && player_step(&p); ++k)
			;
		(void)player_seek(&p, 1);
	}
	player_close(&p);
	free(own);
}
