/*
 * test/stability/reference.c - solutions that the library is compared with, in double precision.
 *
 * A chain of n equal rods in absolute angles q from +x, with lengths l, masses m at half length, inertia I and a point
 * mass M at the end: sum_j c_ij cos(q_i - q_j) q_j'' = - sum_j c_ij sin(q_i - q_j) q_j'^2 - g w_i cos q_i, where
 * w_i = l (m / 2 + m (n - 1 - i) + M), c_ij = l w_max(i,j) for i != j and c_ii = I + m l^2 / 4 + l^2 (m (n - 1 - i) + M).
 * The mass matrix is positive definite: Cholesky.
 */
#include "scene.h"

#include <math.h>

double reference_period(double small_period_s, double angle_rad)
{
	double a = 1.0, b = cos(0.5 * angle_rad);
	while (fabs(a - b) > 1e-15) {
		double mean = 0.5 * (a + b);
		b = sqrt(a * b);
		a = mean;
	}
	return small_period_s / a;
}

typedef struct chain_rate {
	double angle[REFERENCE_LINKS_MAX], speed[REFERENCE_LINKS_MAX];
} chain_rate;

static double beyond(const reference_chain *c, int32_t i) { return c->mass * (double)(c->links - 1 - i) + c->end_mass; }

static double coupling(const reference_chain *c, int32_t i, int32_t j)
{
	int32_t outer = i > j ? i : j;
	double l2 = c->length * c->length;
	return i == j ? c->inertia + l2 * (0.25 * c->mass + beyond(c, i)) : l2 * (0.5 * c->mass + beyond(c, outer));
}

/* Solves a x = b in place of b; a is destroyed. */
static void solve(double a[REFERENCE_LINKS_MAX][REFERENCE_LINKS_MAX], double *b, int32_t n)
{
	int32_t i, j, k;
	for (j = 0; j < n; ++j) {
		for (k = 0; k < j; ++k)
			for (i = j; i < n; ++i)
				a[i][j] -= a[i][k] * a[j][k];
		a[j][j] = sqrt(a[j][j]);
		for (i = j + 1; i < n; ++i)
			a[i][j] /= a[j][j];
	}
	for (i = 0; i < n; ++i) {
		for (k = 0; k < i; ++k)
			b[i] -= a[i][k] * b[k];
		b[i] /= a[i][i];
	}
	for (i = n - 1; i >= 0; --i) {
		for (k = i + 1; k < n; ++k)
			b[i] -= a[k][i] * b[k];
		b[i] /= a[i][i];
	}
}

static void find_rate(const reference_chain *c, chain_rate *rate)
{
	static double matrix[REFERENCE_LINKS_MAX][REFERENCE_LINKS_MAX];
	double cosine[REFERENCE_LINKS_MAX], sine[REFERENCE_LINKS_MAX];
	int32_t i, j;
	for (i = 0; i < c->links; ++i) {
		cosine[i] = cos(c->angle[i]);
		sine[i] = sin(c->angle[i]);
	}
	for (i = 0; i < c->links; ++i) {
		double sum = -c->gravity * c->length * (0.5 * c->mass + beyond(c, i)) * cosine[i];
		for (j = 0; j < c->links; ++j) {
			double cij = coupling(c, i, j);
			matrix[i][j] = cij * (cosine[i] * cosine[j] + sine[i] * sine[j]);
			sum -= cij * (sine[i] * cosine[j] - cosine[i] * sine[j]) * c->speed[j] * c->speed[j];
		}
		rate->angle[i] = c->speed[i];
		rate->speed[i] = sum;
	}
	solve(matrix, rate->speed, c->links);
}

static void move_by(reference_chain *out, const reference_chain *from, const chain_rate *rate, double h)
{
	int32_t i;
	*out = *from;
	for (i = 0; i < from->links; ++i) {
		out->angle[i] += h * rate->angle[i];
		out->speed[i] += h * rate->speed[i];
	}
}

void reference_chain_advance(reference_chain *chain, double duration_s, int32_t steps)
{
	double h = duration_s / (double)steps;
	reference_chain at;
	chain_rate k1, k2, k3, k4;
	int32_t i, step;
	for (step = 0; step < steps; ++step) {
		find_rate(chain, &k1);
		move_by(&at, chain, &k1, 0.5 * h);
		find_rate(&at, &k2);
		move_by(&at, chain, &k2, 0.5 * h);
		find_rate(&at, &k3);
		move_by(&at, chain, &k3, h);
		find_rate(&at, &k4);
		for (i = 0; i < chain->links; ++i) {
			chain->angle[i] += h / 6.0 * (k1.angle[i] + 2.0 * (k2.angle[i] + k3.angle[i]) + k4.angle[i]);
			chain->speed[i] += h / 6.0 * (k1.speed[i] + 2.0 * (k2.speed[i] + k3.speed[i]) + k4.speed[i]);
		}
	}
}

void reference_chain_end(const reference_chain *chain, double *x, double *y)
{
	int32_t i;
	*x = *y = 0.0;
	for (i = 0; i < chain->links; ++i) {
		*x += chain->length * cos(chain->angle[i]);
		*y += chain->length * sin(chain->angle[i]);
	}
}
