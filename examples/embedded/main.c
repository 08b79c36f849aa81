/*
 * examples/embedded/main.c - 50 boxes fall on a heap in one block of memory: no operating system, no malloc, no C library.
 *
 * Prints the state hash, and what a step needs: memory, stack, time. board.h is all that a board provides;
 * board_cortex_m.c and board_host.c implement it.
 */
#include "cairn.h"
#include "embedded/board.h"

#define BODIES 51
#define CONTACTS 128 /* pairs of boxes that are near each other; ... */
#define TOUCHING 96  /* ... and that touch */
#define STEPS 300
#define BLOCK_BYTES (320 * 1024) /* prints how much of it the world needs */

static unsigned char block[BLOCK_BYTES] __attribute__((aligned(64)));

static void print_number(const char *label, uint32_t value)
{
	char text[12];
	int k = 11;
	text[k] = 0;
	do {
		text[--k] = (char)('0' + value % 10u);
		value /= 10u;
	} while (value != 0u);
	board_print(label);
	board_print(text + k);
	board_print("\n");
}

static void print_hash(uint64_t hash)
{
	char text[18];
	int k;
	for (k = 0; k < 16; ++k)
		text[k] = "0123456789abcdef"[hash >> (60 - 4 * k) & 15u];
	text[16] = '\n';
	text[17] = 0;
	board_print("hash ");
	board_print(text);
}

static cn_result add_box(cn_world *world, int32_t type, float x, float y, float half_width, float half_height)
{
	cn_body_def body_def;
	cn_shape_def shape_def;
	cn_body body;
	cn_result result;
	cn_body_def_init(&body_def);
	body_def.type = type;
	body_def.position_m.x = x;
	body_def.position_m.y = y;
	result = cn_body_create(world, &body_def, &body);
	if (result != CN_OK)
		return result;
	cn_shape_def_init(&shape_def);
	shape_def.event_mask = 0;
	shape_def.body = body;
	return cn_shape_create_box(world, &shape_def, half_width, half_height, 0.0f, NULL);
}

/* Ten columns; each box is a little to the side of the one below, so that the columns fall over each other. */
static cn_result build(cn_world *world)
{
	cn_result result = add_box(world, CN_BODY_STATIC, 0.0f, -0.5f, 20.0f, 0.5f);
	int k;
	for (k = 1; k < BODIES && result == CN_OK; ++k) {
		int column = k % 10, floor = k / 10;
		result = add_box(world, CN_BODY_DYNAMIC, (float)column * 1.2f - 6.0f + (float)floor * 0.2f, 0.5f + (float)floor * 1.1f, 0.5f, 0.5f);
	}
	return result;
}

static uint32_t run(cn_world *world)
{
	uint32_t begin = board_ticks(), ticks = 0, now;
	int k;
	for (k = 0; k < STEPS; ++k) {
		cn_world_step(world, 1.0f / 60.0f);
		now = board_ticks();
		ticks += (now - begin) & BOARD_TICKS_MASK;
		begin = now;
	}
	return ticks;
}

/* Divides before it multiplies, so that 32 bits are enough. */
static uint32_t instructions_per_body_and_step(uint32_t ticks)
{
	const uint32_t bodies = STEPS * (BODIES - 1);
	return ticks / bodies * BOARD_INSTRUCTIONS_A_TICK + ticks % bodies * BOARD_INSTRUCTIONS_A_TICK / bodies;
}

int main(void)
{
	cn_world_def def;
	cn_world *world;
	uint64_t bytes, hash;
	uint32_t ticks;
	cn_world_def_init(&def);
	def.solver = CN_SOLVER_SOFT;
	def.body_capacity = def.shape_capacity = BODIES;
	def.contact_capacity = CONTACTS;
	def.touching_capacity = TOUCHING;
	def.event_capacity = 0;
	def.vertex_capacity = 4;
	def.reserve = 0;
	def.memory = block;
	def.memory_bytes = sizeof block;
	if (cn_world_bytes_needed(&def, &bytes) == CN_OK)
		print_number("bytes needed ", (uint32_t)bytes);
	board_stack_paint();
	if (cn_world_create(&def, &world) != CN_OK || build(world) != CN_OK) {
		board_print("the block is too small\n");
		return 1;
	}
	ticks = run(world);
	cn_world_hash(world, &hash);
	print_hash(hash);
	print_number("flash bytes ", board_flash_bytes());
	print_number("stack bytes ", board_stack_bytes());
	print_number("instructions per body and step ", instructions_per_body_and_step(ticks));
	return 0;
}
