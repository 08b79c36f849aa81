/*
 * test/ablation/off.c - linked into programs of a build with -DCNI_ABLATION: before main, the mechanisms that the environment variable
 * CAIRN_OFF names (words of base/ablation.h in any case, with commas between them) are switched off; "list" prints all of them.
 *
 * A program that runs both sides of a comparison calls cni_ablation_use (test/families).
 */
#include "base/ablation.h"
#include "off.h"

#include <ctype.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define NAME_ENTRY(name) #name,
static const char *const names[] = { CNI_MECHANISMS(NAME_ENTRY) };

uint64_t cni_ablation_off;
static uint64_t asked;

static int is_name(const char *word, size_t length, const char *name)
{
	size_t k;
	for (k = 0; k < length && name[k] != '\0'; ++k)
		if (toupper((unsigned char)word[k]) != name[k])
			return 0;
	return k == length && name[k] == '\0';
}

static int mechanism_of(const char *word, size_t length)
{
	int k;
	for (k = 0; k < CNI_MECHANISM_COUNT; ++k)
		if (is_name(word, length, names[k]))
			return k;
	fprintf(stderr, "CAIRN_OFF: there is no mechanism %.*s\n", (int)length, word);
	exit(2);
}

static void list_print(void)
{
	int k;
	for (k = 0; k < CNI_MECHANISM_COUNT; ++k)
		printf("%s\n", names[k]);
	exit(0);
}

__attribute__((constructor)) static void environment_read(void)
{
	const char *word = getenv("CAIRN_OFF");
	if (word != NULL && strcmp(word, "list") == 0)
		list_print();
	while (word != NULL && *word != '\0') {
		size_t length = strcspn(word, ",");
		asked |= (uint64_t)1 << mechanism_of(word, length);
		word += length + (word[length] == ',');
	}
	cni_ablation_off = asked;
}

void cni_ablation_use(int off)
{
	cni_ablation_off = off ? asked : 0;
}
