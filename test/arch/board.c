/*
 * test/arch/board.c - the scenes of scenes.h without an operating system: the boards and start-up code of examples/embedded, and a heap that
 * is an array. Prints a line per scene and "N passed, N failed, 0 skipped".
 */
#include "embedded/board.h"
#include "scenes.h"

#define HEAP_BYTES (3 * 1024 * 1024)
static unsigned char heap[HEAP_BYTES] __attribute__((aligned(64)));
static uint32_t heap_used;

static void *heap_alloc(uint64_t bytes, uint32_t align, void *user)
{
	uint32_t size = (uint32_t)((bytes + 63u) / 64u * 64u);
	void *memory = heap + heap_used;
	(void)align; /* all sizes are multiples of 64 */
	(void)user;
	if (bytes > HEAP_BYTES - heap_used)
		return NULL;
	heap_used += size;
	return memory;
}

/* The last piece only: a scene's memory ends with the scene. */
static void heap_free(void *memory, uint64_t bytes, void *user)
{
	uint32_t size = (uint32_t)((bytes + 63u) / 64u * 64u);
	(void)user;
	if ((unsigned char *)memory + size == heap + heap_used)
		heap_used -= size;
}

static void arch_world_def(cn_world_def *def)
{
	cn_world_def_init(def);
	def->alloc = heap_alloc;
	def->free = heap_free;
}

static void print_hex(uint64_t number)
{
	char text[17];
	int k;
	for (k = 0; k < 16; ++k)
		text[k] = "0123456789abcdef"[number >> (60 - 4 * k) & 15u];
	text[16] = 0;
	board_print(text);
}

int main(void)
{
	int32_t k, passed = 0;
	char count[] = "0 passed, 0 failed, 0 skipped\n";
	for (k = 0; k < ARCH_SCENES; ++k) {
		uint64_t number;
		heap_used = 0;
		number = arch_number(&arch_scenes[k]);
		board_print("  ");
		board_print(arch_scenes[k].name);
		board_print(": ");
		print_hex(number);
		board_print(", golden ");
		print_hex(arch_scenes[k].expected);
		board_print("\n");
		passed += number == arch_scenes[k].expected;
	}
	count[0] = (char)('0' + passed);
	count[10] = (char)('0' + ARCH_SCENES - passed);
	board_print(count);
	return passed != ARCH_SCENES;
}
