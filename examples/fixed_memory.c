/* examples/fixed_memory.c - a world in a block of the program's own: sized from capacities, never more, no malloc. Requests beyond the
   capacity are refused; a step goes on. */
#include "cairn.h"
#include <stdio.h>
#include <stdint.h>

#define BODIES 100

/* With room to align it to 64 bytes. An embedded system would place it by its linker. */
static unsigned char memory[1u << 20];

int main(void)
{
	cn_world_def def;
	cn_world *world;
	cn_body_def body_def;
	cn_shape_def shape_def;
	cn_counters counters;
	cn_memory_stats stats;
	cn_result result = CN_OK;
	uint64_t needed = 0;
	int made = 0;
	cn_world_def_init(&def);
	def.solver = CN_SOLVER_SOFT; /* the least memory */
	def.body_capacity = BODIES;
	def.shape_capacity = BODIES;
	def.contact_capacity = 4 * BODIES;
	def.memory = memory + (64u - (uintptr_t)memory % 64u) % 64u;
	def.memory_bytes = sizeof memory - 64u;
	if (cn_world_bytes_needed(&def, &needed) != CN_OK || needed > def.memory_bytes)
		return 1;
	def.memory_bytes = needed;
	if (cn_world_create(&def, &world) != CN_OK)
		return 1;

	cn_body_def_init(&body_def);
	cn_shape_def_init(&shape_def);
	for (int i = 0; i < 4 * BODIES && result == CN_OK; ++i) {
		body_def.type = i == 0 ? CN_BODY_STATIC : CN_BODY_DYNAMIC;
		body_def.position_m = i == 0 ? (cn_vec2){ 0.0f, -1.0f } : (cn_vec2){ (float)(i % 10) - 4.5f, 0.5f + (float)(i / 10) };
		result = cn_body_create(world, &body_def, &shape_def.body);
		if (result == CN_OK)
			result = cn_shape_create_box(world, &shape_def, i == 0 ? 20.0f : 0.4f, i == 0 ? 1.0f : 0.4f, 0.0f, NULL);
		made += result == CN_OK;
	}
	printf("%d bodies in %llu bytes; then: %s\n", made, (unsigned long long)needed, cn_world_error_text(world));

	for (int step = 0; step < 120; ++step)
		cn_world_step(world, 1.0f / 60.0f);
	cn_world_get_counters(world, &counters);
	cn_world_get_memory_stats(world, &stats);
	printf("after 120 steps: %d touching contacts, %llu bytes at most, warnings %u\n", counters.contacts_touching,
		(unsigned long long)stats.bytes_peak, counters.warnings);
	cn_world_destroy(world);
	return !(made >= BODIES && result == CN_ERROR_MEMORY &&
		stats.bytes_peak <= needed && counters.warnings == 0 && counters.contacts_touching >= made - 1);
}
