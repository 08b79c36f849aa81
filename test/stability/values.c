/*
 * test/stability/values.c - texts of values ("boxes=20 offset=0.01") and of bounds ("pen_max_m<=1e-3 stands>=1").
 */
#include "scene.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

int values_find(const char *text, const char *name, double *out)
{
	size_t length = strlen(name);
	const char *at = text;
	while (at != NULL && *at != '\0') {
		if (strncmp(at, name, length) == 0 && at[length] == '=') {
			*out = strtod(at + length + 1, NULL);
			return 1;
		}
		at = strchr(at, ' ');
		if (at != NULL)
			++at;
	}
	return 0;
}

double scene_value(const scene_run *run, const char *name)
{
	double value = 0.0;
	int32_t k;
	for (k = 3; k >= 0; --k)
		if (run->parameters[k] != NULL && values_find(run->parameters[k], name, &value))
			return value;
	if (!values_find(SCENE_COMMON, name, &value)) {
		fprintf(stderr, "stability: family %s has no parameter %s\n", run->family->name, name);
		exit(2);
	}
	return value;
}

int32_t scene_count(const scene_run *run, const char *name)
{
	return (int32_t)scene_value(run, name);
}

int values_next_bound(const char **text, values_bound *out)
{
	const char *at = *text;
	char *end;
	size_t length;
	while (*at == ' ')
		++at;
	length = strcspn(at, "<>");
	if (at[length] == '\0' || at[length + 1] != '=' || length >= sizeof out->metric)
		return 0;
	memcpy(out->metric, at, length);
	out->metric[length] = '\0';
	out->at_most = at[length] == '<';
	out->bound = strtod(at + length + 2, &end);
	*text = end;
	return 1;
}
