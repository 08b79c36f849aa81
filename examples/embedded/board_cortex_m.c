/*
 * examples/embedded/board_cortex_m.c - start-up code and board functions for a Cortex-M (Arm MPS2 boards, which QEMU emulates).
 *
 * Text goes to the debugger by semihosting. The vector table has the two entries that a program without interrupts needs.
 */
#include "embedded/board.h"

/* sections.ld */
extern uint32_t board_stack_top[], board_bss_begin[], board_bss_end[], board_data_begin[], board_data_end[];
extern const uint32_t board_data_image[];

int main(void);
void board_reset(void);

typedef struct vectors {
	uint32_t *stack;
	void (*reset)(void);
} vectors;
__attribute__((section(".vectors"), used)) static const vectors table = { board_stack_top, board_reset };

#define CPACR (*(volatile uint32_t *)0xe000ed88u)      /* coprocessor access */
#define SYST_CSR (*(volatile uint32_t *)0xe000e010u)   /* SysTick: control, reload, current */
#define SYST_RVR (*(volatile uint32_t *)0xe000e014u)
#define SYST_CVR (*(volatile uint32_t *)0xe000e018u)

static uint32_t semihost(uint32_t operation, const void *argument)
{
	register uint32_t r0 __asm__("r0") = operation;
	register const void *r1 __asm__("r1") = argument;
	__asm__ volatile("bkpt 0xab" : "+r"(r0) : "r"(r1) : "memory");
	return r0;
}

void board_reset(void)
{
	const uint32_t *from = board_data_image;
	uint32_t *to;
	int code;
	for (to = board_data_begin; to < board_data_end; ++to)
		*to = *from++;
	for (to = board_bss_begin; to < board_bss_end; ++to)
		*to = 0;
	CPACR |= 0xfu << 20; /* the floating-point unit */
	__asm__ volatile("dsb\n\tisb");
	SYST_RVR = BOARD_TICKS_MASK;
	SYST_CVR = 0;
	SYST_CSR = 5; /* processor clock, no interrupt */
	code = main();
	(void)semihost(0x18, (const void *)(code == 0 ? 0x20026u : 0x20023u)); /* SYS_EXIT: application exit, run-time error */
	for (;;)
		continue;
}

void board_print(const char *text) { (void)semihost(0x04, text); }

uint32_t board_ticks(void) { return BOARD_TICKS_MASK - SYST_CVR; }
