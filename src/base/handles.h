/*
 * base/handles.h - slots with generations behind the public 32-bit handles.
 *
 *   handle = generation (10 bits) << 22 | kind (2 bits) << 20 | index (20 bits)
 *
 * Generations run from 1 to 1023, so a handle is never 0. Free slots wait in a queue and are reused
 * oldest first; a slot that has used up its generations is retired for good, so a dead handle never
 * comes alive again. Indices below used have been handed out at least once.
 */
#ifndef CNI_BASE_HANDLES_H
#define CNI_BASE_HANDLES_H

#include "base/table.h"

enum { CNI_KIND_BODY = 0, CNI_KIND_SHAPE = 1, CNI_KIND_JOINT = 2, CNI_KIND_CONSTRAINT = 3 };

typedef struct cni_handles {
	cni_array slots;     /* uint32: generation << 22 | alive << 21 | next free index + 1 */
	int32_t kind;
	int32_t count;       /* alive */
	int32_t free_first;  /* index or CNI_NONE */
	int32_t free_last;
	int32_t retired;
} cni_handles;

void cni_handles_init(cni_handles *handles, int32_t kind);
void cni_handles_deinit(cni_handles *handles, cni_memory *memory);
/* Makes the next cni_handles_take calls up to extra in number certain to succeed. Returns CN_OK,
   CN_ERROR_MEMORY, or CN_ERROR_CAPACITY when indices run out. */
cn_result cni_handles_reserve(cni_handles *handles, cni_memory *memory, int32_t extra);
/* The index the next take would give. */
int32_t cni_handles_peek(const cni_handles *handles);
int32_t cni_handles_take(cni_handles *handles);
void cni_handles_release(cni_handles *handles, int32_t index);
/* Index of a live handle of this kind, or CNI_NONE. Any 32 bits may come in. */
int32_t cni_handles_find(const cni_handles *handles, uint32_t handle);
/* Handle of a live index. */
uint32_t cni_handles_of(const cni_handles *handles, int32_t index);
int32_t cni_handles_alive(const cni_handles *handles, int32_t index);
/* One past the highest index ever taken. */
int32_t cni_handles_used(const cni_handles *handles);

#endif
