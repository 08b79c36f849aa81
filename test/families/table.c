/*
 * test/families/table.c - rows of CSV, written and read back.
 */
#include "judge.h"

#include <string.h>

void write_csv(FILE *file, const char *name, int32_t seed, const char *engine, const scene_measures *m, uint32_t worse)
{
	if (file == NULL)
		return;
	fprintf(file, "%s,%d,%s,%.9g,%.9g,%.9g,%.9g,%.9g,%.9g,%.9g,%.9g,%.9g,%.9g,%.9g,%d,%d,%d,%d,%d,%d,%.9g,%.9g,%u\n", name, (int)seed, engine, m->joint_max, m->joint_p99,
		m->joint_mean, m->overlap_max, m->overlap_p99, m->energy_pct, m->speed_max, m->speed_fall, m->moved_m, m->step_ms, m->step_max_ms, (int)m->steps,
		(int)m->broken, (int)m->at_limit, (int)m->bodies, (int)m->joints, (int)m->refused, m->joint_start,
		m->overlap_start, (unsigned)worse);
}

void write_csv_head(FILE *file)
{
	if (file != NULL)
		fprintf(file, "family,seed,engine,joint_max_m,joint_p99_m,joint_mean_m,overlap_max_m,overlap_p99_m,energy_pct,speed_max_mps,speed_fall_mps,moved_m,step_ms,"
			      "step_max_ms,steps,broken,at_limit,bodies,joints,refused,joint_start_m,overlap_start_m,worse\n");
}

static int read_row(const char *line, char name[64], int *seed, scene_measures *m)
{
	int steps, broken, limit, bodies, joints, refused;
	memset(m, 0, sizeof *m);
	if (sscanf(line, "%63[^,],%d,%*[^,],%lf,%lf,%lf,%lf,%lf,%lf,%lf,%lf,%lf,%lf,%lf,%d,%d,%d,%d,%d,%d", name, seed, &m->joint_max, &m->joint_p99, &m->joint_mean, &m->overlap_max,
		    &m->overlap_p99, &m->energy_pct, &m->speed_max, &m->speed_fall, &m->moved_m, &m->step_ms, &m->step_max_ms, &steps, &broken, &limit, &bodies, &joints, &refused)
		!= 19)
		return 0;
	m->steps = steps;
	m->broken = broken;
	m->at_limit = limit;
	m->refused = refused;
	return 1;
}

int find_peer(const settings *set, const char *name, int32_t seed, uint32_t flags, judged *out, scene_measures *first)
{
	double values[M_COUNT][RUNS_MAX];
	char line[512], found[64];
	int32_t rows = 0, count = 0;
	int at;
	while (set->peer != NULL && rows < PEER_RUNS && fgets(line, (int)sizeof line, set->peer) != NULL) {
		scene_measures m;
		judged j;
		if (!read_row(line, found, &at, &m) || strcmp(found, name) != 0 || at != seed)
			continue;
		++rows;
		if (m.refused)
			continue;
		m.flags = flags;
		j = to_judged(&m);
		if (count == 0)
			*first = m;
		keep_values(values, count++, &j);
	}
	if (count > 0)
		*out = median_judged(values, count);
	return count > 0;
}
