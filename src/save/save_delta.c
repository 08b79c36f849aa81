/*
 * save/save_delta.c - the difference of two saves: the words of 8 bytes that have changed.
 *
 *   header   magic (8) | checksum of all that follows (8) | checksum of the base (8) | bytes of the save (8)
 *   run      words that are as in the base (4) | words that follow (4) | words
 *   tail     the save's last bytes, less than a word
 *
 * Equal words between two changes are copied with them where that is shorter than a new run.
 */
#include "save/file.h"

#include <string.h>

#define HEADER_BYTES 32u
#define WORD 8u
#define RUN_GAP 1u   /* a run's head takes a word, so one equal word is no reason for a new run */
#define MAGIC 0x41544C4544434343u

static uint64_t word_at(const uint8_t *bytes, uint64_t word)
{
	uint64_t value;
	memcpy(&value, bytes + word * WORD, sizeof value);
	return value;
}

/* Bytes that may be written or only counted. */
typedef struct writer {
	uint8_t *at; /* NULL: counts */
	uint64_t bytes;
} writer;

static void put(writer *w, const void *bytes, uint64_t count)
{
	if (w->at != NULL && count > 0)
		memcpy(w->at + w->bytes, bytes, (size_t)count);
	w->bytes += count;
}

typedef struct pair {
	const uint8_t *base, *save;
	uint64_t base_words, save_words;
} pair;

static int32_t same(const pair *p, uint64_t word)
{
	return word < p->base_words && word_at(p->base, word) == word_at(p->save, word);
}

/* One past the last word of the run of changes that begins here. */
static uint64_t run_end(const pair *p, uint64_t word)
{
	uint64_t end = word;
	while (word < p->save_words && word - end <= RUN_GAP) {
		end = same(p, word) ? end : word + 1;
		++word;
	}
	return end;
}

static void put_runs(writer *w, const pair *p)
{
	uint64_t word = 0;
	while (word < p->save_words) {
		uint64_t from = word, end;
		uint32_t head[2];
		while (word < p->save_words && same(p, word) && word - from < UINT32_MAX)
			++word;
		end = run_end(p, word);
		end = end - word < UINT32_MAX ? end : word + UINT32_MAX;
		head[0] = (uint32_t)(word - from);
		head[1] = (uint32_t)(end - word);
		put(w, head, sizeof head);
		put(w, p->save + word * WORD, (end - word) * WORD);
		word = end;
	}
}

static void delta_put(writer *w, const void *base, uint64_t base_bytes, const void *save, uint64_t save_bytes)
{
	uint64_t header[4] = { MAGIC, 0, cni_save_checksum(base, base_bytes), save_bytes };
	const pair p = { (const uint8_t *)base, (const uint8_t *)save, base_bytes / WORD, save_bytes / WORD };
	put(w, header, sizeof header);
	put_runs(w, &p);
	put(w, p.save + p.save_words * WORD, save_bytes % WORD);
	if (w->at != NULL) {
		header[1] = cni_save_checksum(w->at + 2 * WORD, w->bytes - 2 * WORD);
		memcpy(w->at + WORD, &header[1], WORD);
	}
}

cn_result cn_save_delta_size(const void *base, uint64_t base_bytes, const void *save, uint64_t save_bytes, uint64_t *out_bytes)
{
	writer w = { NULL, 0 };
	if (out_bytes == NULL || base == NULL || save == NULL)
		return CN_ERROR_ARGUMENT;
	if (!cni_save_is_one(base, base_bytes) || !cni_save_is_one(save, save_bytes))
		return CN_ERROR_FORMAT;
	delta_put(&w, base, base_bytes, save, save_bytes);
	*out_bytes = w.bytes;
	return CN_OK;
}

cn_result cn_save_delta(const void *base, uint64_t base_bytes, const void *save, uint64_t save_bytes, void *out, uint64_t capacity, uint64_t *out_bytes)
{
	writer w = { (uint8_t *)out, 0 };
	uint64_t bytes;
	cn_result sized = out != NULL ? cn_save_delta_size(base, base_bytes, save, save_bytes, &bytes) : CN_ERROR_ARGUMENT;
	if (sized != CN_OK || bytes > capacity)
		return sized != CN_OK ? sized : CN_ERROR_CAPACITY;
	delta_put(&w, base, base_bytes, save, save_bytes);
	if (out_bytes != NULL)
		*out_bytes = w.bytes;
	return CN_OK;
}

/* ---- applying ---- */

/* The save's words from the runs; 0: they do not give so many. */
static int32_t runs_apply(const pair *p, const uint8_t *runs, uint64_t bytes, uint8_t *out)
{
	uint64_t word = 0, at = 0;
	while (word < p->save_words) {
		uint32_t head[2];
		if (bytes - at < sizeof head)
			return 0;
		memcpy(head, runs + at, sizeof head);
		at += sizeof head;
		if ((head[0] == 0 && head[1] == 0) || head[0] > p->save_words - word || (head[0] > 0 && word + head[0] > p->base_words) ||
		    head[1] > p->save_words - word - head[0] || head[1] > (bytes - at) / WORD)
			return 0;
		memcpy(out + word * WORD, p->base + word * WORD, head[0] * (size_t)WORD);
		word += head[0];
		memcpy(out + word * WORD, runs + at, head[1] * (size_t)WORD);
		word += head[1];
		at += head[1] * (uint64_t)WORD;
	}
	return 1;
}

static int32_t delta_is_good(const uint8_t *delta, uint64_t bytes, const void *base, uint64_t base_bytes)
{
	return bytes >= HEADER_BYTES && word_at(delta, 0) == MAGIC && word_at(delta, 1) == cni_save_checksum(delta + 2 * WORD, bytes - 2 * WORD) &&
	       word_at(delta, 2) == cni_save_checksum(base, base_bytes);
}

cn_result cn_save_apply(const void *base, uint64_t base_bytes, const void *delta, uint64_t delta_bytes, void *out, uint64_t capacity, uint64_t *out_bytes)
{
	const uint8_t *from = (const uint8_t *)delta;
	pair p = { (const uint8_t *)base, NULL, base_bytes / WORD, 0 };
	if (base == NULL || delta == NULL || out == NULL)
		return CN_ERROR_ARGUMENT;
	if (!delta_is_good(from, delta_bytes, base, base_bytes))
		return CN_ERROR_FORMAT;
	uint64_t bytes = word_at(from, 3);
	uint64_t tail = bytes % WORD;
	if (bytes > capacity)
		return CN_ERROR_CAPACITY;
	p.save_words = bytes / WORD;
	if (delta_bytes - HEADER_BYTES < tail || !runs_apply(&p, from + HEADER_BYTES, delta_bytes - HEADER_BYTES - tail, (uint8_t *)out))
		return CN_ERROR_FORMAT;
	memcpy((uint8_t *)out + p.save_words * WORD, from + delta_bytes - tail, (size_t)tail);
	if (out_bytes != NULL)
		*out_bytes = bytes;
	return CN_OK;
}
