/*
 * test/ablation/tuning.c - linked into programs of a build with -DCNI_ABLATION: defines the tuning constants of model/tuning.h as variables.
 * Before main, those that the environment variable CAIRN_TUNE names are scaled: "CNI_SNAP_RAD=0.7,CNI_TRUST_MOST=1.4". Counts are rounded, and
 * change by one at least. "list" prints all names with their values.
 */
#include "base/config.h"

#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define CNI_TUNING_LIST
#define CNI_TUNING_FLOAT(name, value) float name = value;
#define CNI_TUNING_COUNT(name, value) int32_t name = value;
#undef CNI_MODEL_TUNING_H
#include "model/tuning.h"

typedef struct constant {
	const char *name;
	float *number; /* or NULL */
	int32_t *count;
} constant;

static const constant constants[] = {
#define CNI_TUNING_FLOAT(name, value) { #name, &name, NULL },
#define CNI_TUNING_COUNT(name, value) { #name, NULL, &name },
#undef CNI_MODEL_TUNING_H
#include "model/tuning.h"
};
enum { CONSTANTS = (int)(sizeof constants / sizeof constants[0]) };

static void list_print(void)
{
	int k;
	for (k = 0; k < CONSTANTS; ++k)
		printf("%s %.7g\n", constants[k].name, constants[k].number != NULL ? (double)*constants[k].number : (double)*constants[k].count);
	exit(0);
}

static void constant_scale(const constant *c, double factor)
{
	int32_t scaled;
	if (c->number != NULL) {
		*c->number = (float)(factor * (double)*c->number);
		return;
	}
	scaled = (int32_t)(factor * (double)*c->count + 0.5);
	if (scaled == *c->count && factor != 1.0)
		scaled += factor > 1.0 ? 1 : -1;
	*c->count = scaled;
}

static const constant *constant_of(const char *word, size_t length)
{
	int k;
	for (k = 0; k < CONSTANTS; ++k)
		if (strlen(constants[k].name) == length && memcmp(constants[k].name, word, length) == 0)
			return constants + k;
	fprintf(stderr, "CAIRN_TUNE: there is no constant %.*s\n", (int)length, word);
	exit(2);
}

__attribute__((constructor)) static void environment_read(void)
{
	const char *word = getenv("CAIRN_TUNE");
	if (word != NULL && strcmp(word, "list") == 0)
		list_print();
	while (word != NULL && *word != '\0') {
		size_t name = strcspn(word, "=,"), length = strcspn(word, ",");
		double factor = word[name] == '=' ? strtod(word + name + 1, NULL) : 0.0;
		if (!(factor > 0.0)) {
			fprintf(stderr, "CAIRN_TUNE: name=factor, not %.*s\n", (int)length, word);
			exit(2);
		}
		constant_scale(constant_of(word, name), factor);
		word += length + (word[length] == ',');
	}
}
