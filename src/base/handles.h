/*
 * base/handles.h - slots with generations behind the public 32-bit handles.
 *
 *   handle = generation (10 bits) << 22 | kind (2 bits) << 20 | index (20 bits)
 *
 * Generations run from 1 to 1023, so a handle is never 0. Free slots wait in a queue and are reused oldest first. A slot
 * begins with its own index. When that has used up its generations, the slot goes on under an alias: an index from the other
 * end of the 20 bits, which no slot has or will have as its own, with 1023 generations of its own; then under the next one.
 *
 *   index  0 ........... slots - 1        alias_next ........ 2^20 - 1
 *          own indices ->                      <- aliases, each given once
 *
 * So a handle comes alive again only when all aliases have been given: after (2^20 - slots) * 1023 lives of slots that have worn
 * out their own index. Then aliases begin again at the end. Worlds in which no slot wears out have no aliases, and
 * pay nothing for them.
 */
#ifndef CNI_BASE_HANDLES_H
#define CNI_BASE_HANDLES_H

#include "base/table.h"

#define CNI_HANDLE_GENERATION_SHIFT 22
#define CNI_HANDLE_KIND_SHIFT 20
#define CNI_HANDLE_INDEX_MASK 0xFFFFFu
#define CNI_HANDLE_ALIVE_BIT (1u << 21) /* of a slot */

enum { CNI_KIND_BODY = 0, CNI_KIND_SHAPE = 1, CNI_KIND_JOINT = 2, CNI_KIND_CONSTRAINT = 3 };

/* Which slot goes by an alias. */
typedef struct cni_alias {
	int32_t index;
	int32_t slot;
} cni_alias;

typedef struct cni_handles {
	cni_array slots;     /* uint32: generation << 22 | alive << 21 | alias, or of a free slot next + 1; generation 0: it needs an alias */
	cni_array aliases;   /* cni_alias of the slots that have one, by rising index */
	cni_array by_slot;   /* the same by rising slot */
	int32_t kind;
	int32_t count;       /* alive; the members from here on are saved as one */
	int32_t free_first;  /* index or CNI_NONE */
	int32_t free_last;
	int32_t worn;        /* free slots that need an alias */
	int32_t alias_next;  /* aliases below have not been given */
} cni_handles;

void cni_handles_init(cni_handles *handles, int32_t kind);
void cni_handles_deinit(cni_handles *handles, cni_memory *memory);
/* Makes the next cni_handles_take calls up to extra in number certain to succeed. Returns CN_OK,
   CN_ERROR_MEMORY, or CN_ERROR_CAPACITY when indices run out. */
cn_result cni_handles_reserve(cni_handles *handles, cni_memory *memory, int32_t extra);
/* Room for aliases of this many slots, so that no reserve up to them needs any more. 0: no memory. */
int32_t cni_handles_reserve_aliases(cni_handles *handles, cni_memory *memory, int32_t slots);
/* The slot the next take would give. */
int32_t cni_handles_peek(const cni_handles *handles);
int32_t cni_handles_take(cni_handles *handles);
void cni_handles_release(cni_handles *handles, int32_t slot);
/* cni_handles_find of handles that have aliases. O(log of their number). */
int32_t cni_handles_find_alias(const cni_handles *handles, uint32_t handle);
/* The alias of a slot, alive or free; 0: none. */
int32_t cni_handles_alias_of(const cni_handles *handles, int32_t slot);
/* Handle of a live slot. */
uint32_t cni_handles_of(const cni_handles *handles, int32_t slot);
int32_t cni_handles_alive(const cni_handles *handles, int32_t slot);
/* One past the highest slot ever taken. */
static inline int32_t cni_handles_used(const cni_handles *handles) { return handles->slots.count; }

/* The first live slot from this one on; CNI_NONE: there are no more. */
static inline int32_t cni_handles_next(const cni_handles *handles, int32_t slot)
{
	const uint32_t *words = (const uint32_t *)handles->slots.data;
	for (; slot < handles->slots.count; ++slot)
		if (words[slot] & CNI_HANDLE_ALIVE_BIT)
			return slot;
	return CNI_NONE;
}

/* Without aliases, the word of a live slot. */
static inline uint32_t cni_handles_word(uint32_t handle)
{
	return handle >> CNI_HANDLE_GENERATION_SHIFT << CNI_HANDLE_GENERATION_SHIFT | CNI_HANDLE_ALIVE_BIT;
}

/* Slot of a live handle of this kind, or CNI_NONE. Any 32 bits may come in. */
static inline int32_t cni_handles_find(const cni_handles *handles, uint32_t handle)
{
	int32_t slot = (int32_t)(handle & CNI_HANDLE_INDEX_MASK);
	if (handles->aliases.count > 0)
		return cni_handles_find_alias(handles, handle);
	return (handle >> CNI_HANDLE_KIND_SHIFT & 3u) == (uint32_t)handles->kind && slot < handles->slots.count &&
		((const uint32_t *)handles->slots.data)[slot] == cni_handles_word(handle) ? slot : CNI_NONE;
}

/* Whether all are live handles of this kind. */
int32_t cni_handles_find_all(const cni_handles *handles, const uint32_t *list, int32_t count);

/* Slot of a handle that is known to be live. */
static inline int32_t cni_handles_slot(const cni_handles *handles, uint32_t handle)
{
	return handles->aliases.count == 0 ? (int32_t)(handle & CNI_HANDLE_INDEX_MASK) : cni_handles_find(handles, handle);
}

#endif
