/*
 * examples/embedded/board_riscv.c - start-up code and board functions for a 32-bit RISC-V (the virt board of QEMU).
 *
 * Text goes to the debugger by semihosting; the counter is that of executed instructions.
 */
#include "embedded/board.h"

/* sections.ld */
extern uint32_t board_bss_begin[], board_bss_end[], board_data_begin[], board_data_end[];
extern const uint32_t board_data_image[];

int main(void);
void board_start(void);
void board_reset(void);

__attribute__((section(".vectors"), used, naked)) void board_reset(void)
{
	__asm__ volatile("la sp, board_stack_top\n\tj board_start");
}

static uint32_t semihost(uint32_t operation, const void *argument)
{
	register uint32_t a0 __asm__("a0") = operation;
	register const void *a1 __asm__("a1") = argument;
	/* The debugger knows the call by these three uncompressed instructions, which must be in one page. */
	__asm__ volatile(".option push\n\t.option norvc\n\t.balign 16\n\tslli x0, x0, 0x1f\n\tebreak\n\tsrai x0, x0, 7\n\t.option pop" : "+r"(a0) : "r"(a1) : "memory");
	return a0;
}

__attribute__((used)) void board_start(void)
{
	const uint32_t *from = board_data_image;
	uint32_t *to;
	int code;
	for (to = board_data_begin; to < board_data_end; ++to)
		*to = *from++;
	for (to = board_bss_begin; to < board_bss_end; ++to)
		*to = 0;
	__asm__ volatile("csrs mstatus, %0" : : "r"(0x2000u)); /* the floating-point unit */
	code = main();
	(void)semihost(0x18, (const void *)(code == 0 ? 0x20026u : 0x20023u)); /* SYS_EXIT: application exit, run-time error */
	for (;;)
		continue;
}

void board_print(const char *text) { (void)semihost(0x04, text); }

uint32_t board_ticks(void)
{
	uint32_t count;
	__asm__ volatile("csrr %0, minstret" : "=r"(count));
	return count;
}
