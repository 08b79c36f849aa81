/*
 * broadphase/sweep.h - private to the files of the tiled sweep-and-prune broadphase, which src/README.md lists.
 *
 * Boxes are sorted by size into levels (S_l = S0 * 4^l: a box goes to the lowest level whose S_l exceeds its larger
 * side), and within a level by their lower corner into tiles 8 S_l wide and 2 S_l high:
 *
 *        +--------------- 8 S ---------------+ . . .
 *    2 S |   [a]      [b  ]            [ c ] |  ]  .   an entry is in exactly one tile and reaches
 *        |       [ d ]                     [ | e ] .   less than S beyond it
 *        +-----------------------------------+     .
 *
 *   a tile's rows (one piece of the pool `rows`), sorted by x0, ties by id:
 *
 *     x0 [ . . . . . inf inf inf ]     capacity is a multiple of 8 (or 2 or 4); x0 is padded with +inf
 *     x1 [ . . . . .             ]     up to a multiple of 8, so that wide loops need no tail
 *     y0 [ . . . . .             ]
 *     y1 [ . . . . .             ]
 *     id [ . . . . .             ]
 *
 * Tiles do not store the boxes of the last update: an unmoved proxy's old box equals its present box, and for tiles with
 * many moved entries update gathers the old boxes into scratch rows. That saves 16 bytes per proxy and the copying back.
 *
 * Two sets of proxies, each a bitset by id. `moved`: the box changed since the last update, so there may be new pairs.
 * `loose`: the box changed since the last settle, so the entry in the tile is missing or out of date. Queries skip the
 * entries of loose proxies in tiles and test the loose proxies one by one. A proxy for which there is no memory stays
 * loose and is retried at every settle: the loose set is the slow list of broadphase/broadphase.h.
 *
 * Method: sweep and prune after Baraff (1992) and Cohen et al. (I-COLLIDE, 1995), per cell of a
 * hierarchical grid (Mirtich 1996) rather than over the whole world, so that no list is long.
 */
#ifndef CNI_BROADPHASE_SWEEP_H
#define CNI_BROADPHASE_SWEEP_H

#include "base/bitset.h"
#include "broadphase/broadphase.h"

#define CNI_SWEEP_LEVELS 12     /* the last one is a single list for whatever is larger */
#define CNI_SWEEP_LANES 8       /* entries tested together */
#define CNI_SWEEP_FREE 255      /* level of a free tile slot */

typedef struct cni_sweep_tile {
	int32_t tx, ty;        /* the cell; in a free slot tx is the next free slot */
	uint8_t level;
	uint8_t dense;         /* 1: the running pass handles the tile as a whole */
	uint16_t reserved;
	cni_ref rows;
	int32_t count;
	int32_t capacity;
	float reach;           /* upper bound of the width of entries */
	cni_aabb bounds;       /* contains every entry; tight after a rebuild */
	int32_t slack;         /* changes since bounds were tight */
	int32_t touched;       /* in a running pass: number of proxies that change here; else 0 */
	int32_t previous;      /* of a dense tile in update: first float of its scratch rows, CNI_NONE if all entries are new */
} cni_sweep_tile;

typedef struct cni_sweep_rows {
	float *x0, *x1, *y0, *y1;
	int32_t *id;
} cni_sweep_rows;

typedef struct cni_sweep_level {
	float size;                     /* S, an upper bound of the boxes' larger sides */
	float per_width, per_height;    /* 1 / (8 S), 1 / (2 S); 0 in the last level */
	float reach;                    /* largest entry since S was set: about S at most, except in the last level */
	int32_t tiles;
	int32_t entries;
	int32_t tx0, tx1, ty0, ty1;     /* range of the cells of tiles; valid while there are tiles */
} cni_sweep_level;

typedef struct cni_sweep {
	cni_broadphase_context context;
	cni_array tiles;       /* cni_sweep_tile */
	int32_t *slots;        /* open addressing, (level, tx, ty) -> tile + 1; 0 is empty */
	int32_t slot_capacity; /* 0 or a power of two */
	int32_t tile_count;
	cni_array moved;       /* uint64_t, one bit per id */
	cni_array loose;       /* uint64_t, one bit per id */
	cni_blocks rows;       /* pool of the rows of all tiles, emptied when sizes change */

	int32_t tile_free;     /* first free slot or CNI_NONE; the members from here on are saved as one */
	int32_t id_end;        /* all ids in use are below */
	int32_t count;         /* proxies */
	int32_t moved_count;
	int32_t loose_count;
	uint32_t level_mask;   /* levels that have tiles */
	cni_sweep_level levels[CNI_SWEEP_LEVELS];
	int32_t exponent;      /* S0 = 2^exponent */
	int32_t boost;         /* powers of two by which S0 exceeds the size of the boxes, so that tiles are well filled */
	int32_t tuned_count;   /* proxies when sizes were last chosen, 0 for never */
	int32_t adds;          /* since sizes were last chosen */
	int32_t settles;       /* since sizes were last chosen */
	int32_t patience;      /* settles that must pass before badly filled tiles change S0 */
} cni_sweep;

/* Cells of a level that a search visits. */
typedef struct cni_sweep_cells {
	int32_t tx0, tx1, ty0, ty1;
} cni_sweep_cells;

/* Iterates over all tiles whose entries may overlap a box, by level, row and column. */
typedef struct cni_sweep_cursor {
	cni_aabb box;
	cni_sweep_cells cells;
	int32_t level;
	int32_t tx, ty;
	int32_t slot;          /* >= 0: iterates over all tile slots instead, because there are more cells than tiles */
} cni_sweep_cursor;

/* Iterates over set bits in ascending order; bits already visited may be cleared meanwhile. */
typedef struct cni_sweep_walk {
	const uint64_t *words;
	uint64_t rest;
	int32_t word, end;
} cni_sweep_walk;

static inline cni_proxy *cni_sweep_proxy(const cni_sweep *sweep, int32_t id)
{
	return (cni_proxy *)cni_table_at(sweep->context.proxies, id);
}

static inline cni_sweep_tile *cni_sweep_tile_at(const cni_sweep *sweep, int32_t tile)
{
	return (cni_sweep_tile *)sweep->tiles.data + tile;
}

static inline uint64_t *cni_sweep_moved(const cni_sweep *sweep) { return (uint64_t *)sweep->moved.data; }
static inline uint64_t *cni_sweep_loose(const cni_sweep *sweep) { return (uint64_t *)sweep->loose.data; }

/* Adds an id to a set of this number of ids. */
static inline void cni_sweep_mark(uint64_t *words, int32_t id, int32_t *count)
{
	*count += !cni_bit_get(words, id);
	cni_bit_set(words, id);
}

static inline cni_team *cni_sweep_team(const cni_sweep *sweep) { return sweep->context.team == NULL ? NULL : *sweep->context.team; }

static inline cni_sweep_rows cni_sweep_rows_at(float *first, int32_t capacity)
{
	cni_sweep_rows rows = { first, first + capacity, first + 2 * capacity, first + 3 * capacity, (int32_t *)(first + 4 * capacity) };
	return rows;
}

static inline cni_sweep_rows cni_sweep_rows_of(const cni_sweep *sweep, const cni_sweep_tile *tile)
{
	return cni_sweep_rows_at((float *)cni_blocks_at(&sweep->rows, tile->rows), tile->capacity);
}

static inline cni_aabb cni_sweep_box_at(const cni_sweep_rows *rows, int32_t k)
{
	cni_aabb box = { rows->x0[k], rows->y0[k], rows->x1[k], rows->y1[k] };
	return box;
}

static inline void cni_sweep_box_set(const cni_sweep_rows *rows, int32_t k, const cni_aabb *box)
{
	rows->x0[k] = box->x0;
	rows->x1[k] = box->x1;
	rows->y0[k] = box->y0;
	rows->y1[k] = box->y1;
}

static inline void cni_sweep_entry_set(const cni_sweep_rows *rows, int32_t k, int32_t id, const cni_aabb *box)
{
	cni_sweep_box_set(rows, k, box);
	rows->id[k] = id;
}

/* count: ids in the set. */
static inline cni_sweep_walk cni_sweep_walk_bits(const cni_sweep *sweep, const cni_array *bits, int32_t count)
{
	cni_sweep_walk walk = { (const uint64_t *)bits->data, 0, -1, count > 0 ? cni_bit_words(sweep->id_end) : 0 };
	return walk;
}

/* The next id, or CNI_NONE. */
static inline int32_t cni_sweep_walk_next(cni_sweep_walk *walk)
{
	while (walk->rest == 0) {
		if (++walk->word >= walk->end)
			return CNI_NONE;
		walk->rest = walk->words[walk->word];
	}
	int32_t bit = cni_bit_lowest64(walk->rest);
	walk->rest &= walk->rest - 1;
	return walk->word * 64 + bit;
}

/* Do a sixth or more of the tile's entries change, and not only one or two? Then a running pass handles it as a whole. */
static inline int32_t cni_sweep_many_touched(const cni_sweep_tile *tile) { return tile->touched >= 3 && 6 * tile->touched >= tile->count; }

/* Floor, clamped: all cells beyond 2^30 are one cell; NaN goes to one end. */
static inline int32_t cni_sweep_floor(float x)
{
	float limited = x > -1073741824.0f ? (x < 1073741824.0f ? x : 1073741824.0f) : -1073741824.0f;
	int32_t whole = (int32_t)limited;
	return whole - ((float)whole > limited);
}

/* The cell of a lower corner. Monotone in x and y. */
static inline int32_t cni_sweep_cell_x(const cni_sweep_level *level, float x) { return cni_sweep_floor(x * level->per_width); }
static inline int32_t cni_sweep_cell_y(const cni_sweep_level *level, float y) { return cni_sweep_floor(y * level->per_height); }

static inline float cni_sweep_extent(const cni_aabb *box) { return cni_max(box->x1 - box->x0, box->y1 - box->y0); }

/* ---- tiles ---- */

/* Sets S0 = 2^exponent; there must be no tiles. */
void cni_sweep_set_levels(cni_sweep *sweep, int32_t exponent);
/* The level for a box of this extent; a box at level `now` moves to a lower level only when it is much smaller. */
int32_t cni_sweep_level_for(const cni_sweep *sweep, float extent, int32_t now);
/* Cells whose entries may overlap the box; 0 when there are none. */
int32_t cni_sweep_cells_of(const cni_sweep_level *level, const cni_aabb *box, cni_sweep_cells *out);
/* Tile of a cell, or CNI_NONE. */
int32_t cni_sweep_tile_find(const cni_sweep *sweep, int32_t level, int32_t tx, int32_t ty);
/* Makes the missing tile of a cell; CNI_NONE when there is no memory. May move the tile array. */
int32_t cni_sweep_tile_make(cni_sweep *sweep, int32_t level, int32_t tx, int32_t ty);
void cni_sweep_tile_destroy(cni_sweep *sweep, int32_t tile);
/* Makes room for count tiles in the table from cells to tiles; 0 when there is no memory. */
int32_t cni_sweep_slots_reserve(cni_sweep *sweep, int32_t count);
/* Rebuilds that table from the tiles. */
void cni_sweep_slots_fill(cni_sweep *sweep);
/* Reduces the capacity of a tile that holds far fewer entries. */
void cni_sweep_tile_shrink(cni_sweep *sweep, cni_sweep_tile *tile);
/* Recomputes bounds and reach. Returns the largest extent of its entries, which the level must cover. */
float cni_sweep_tile_measure(const cni_sweep *sweep, cni_sweep_tile *tile);
/* Raises the level's reach to an entry of this extent. */
void cni_sweep_level_cover(cni_sweep_level *level, float extent);
/* Writes +inf to the x0 row behind the last entry, up to a multiple of CNI_SWEEP_LANES. */
void cni_sweep_tile_pad(const cni_sweep *sweep, cni_sweep_tile *tile);
/* First entry at or after (x0, id). */
int32_t cni_sweep_entry_bound(const cni_sweep_rows *rows, int32_t count, float x0, int32_t id);
/* First entry that begins at or after x0. Branchless binary search: branches would be mispredicted half of the time. */
static inline int32_t cni_sweep_entry_from(const float *x0s, int32_t count, float x0)
{
	int32_t low = 0, left = count;
	while (left > 0) {
		int32_t half = (left + 1) / 2;
		low += half & -(x0s[low + half - 1] < x0);
		left -= half;
	}
	return low;
}
/* Inserts in sorted order; 0 when there is no memory. */
int32_t cni_sweep_entry_insert(cni_sweep *sweep, cni_sweep_tile *tile, int32_t id, const cni_aabb *box);
/* Appends the id alone, unsorted and without padding, for a rebuild that follows; 0 when there is no memory. */
int32_t cni_sweep_entry_append(cni_sweep *sweep, cni_sweep_tile *tile, int32_t id);
/* Removes a proxy's entry from its tile. */
void cni_sweep_entry_remove(cni_sweep *sweep, cni_sweep_tile *tile, int32_t id);
/* Gives a proxy's entry a new box and moves it to its sorted place. */
void cni_sweep_entry_shift(cni_sweep *sweep, cni_sweep_tile *tile, int32_t id, const cni_aabb *box);

void cni_sweep_cursor_start(const cni_sweep *sweep, cni_sweep_cursor *cursor, const cni_aabb *box);
/* The next tile whose bounds overlap the box, or CNI_NONE. */
int32_t cni_sweep_cursor_next(const cni_sweep *sweep, cni_sweep_cursor *cursor);

/* ---- settle ---- */

/* Afterwards tiles agree with the boxes, except for proxies that stay loose because memory is short. team: the workers
   that share the work, or NULL. */
void cni_sweep_settle(cni_sweep *sweep, cni_team *team);

/* ---- pairs ---- */

/* Appends the new pairs in no particular order; see broadphase/broadphase.h. Proxies may be loose only because memory is
   short. For a pair without room in the list, one of its moved proxies is flagged CNI_PROXY_AGAIN. */
void cni_sweep_find_pairs(cni_sweep *sweep, cni_pair_filter_fn *filter, const void *filter_context, cni_broadphase_pairs *out);

/* Rows of a tile with the boxes of the last update. */
typedef struct cni_sweep_view {
	cni_sweep_rows now, old; /* old.id is not used */
	int32_t count;
	int32_t wide;      /* 1: rows are padded to whole groups of lanes */
	float reach;
	int32_t skip_moved;/* 1: moved entries are skipped, because their own searches find their pairs */
} cni_sweep_view;

/* The box that is tested against a tile's entries. */
typedef struct cni_sweep_probe {
	cni_aabb now;
	cni_aabb old;
	int32_t id;
	int32_t skip_moved;
} cni_sweep_probe;

/*
 * Finds the first group of CNI_SWEEP_LANES entries from *k on that contains new overlaps with the probe (now, but not at
 * the last update). Returns them as bits and the group's begin in *k; 0 when entries begin beyond the probe first.
 * wanted: mask for the first group.
 */
typedef uint32_t cni_sweep_find_new_fn(const cni_sweep_probe *q, const cni_sweep_view *v, int32_t *k, uint32_t wanted);
cni_sweep_find_new_fn cni_sweep_find_new;   /* vectors of four floats, or scalar */
cni_sweep_find_new_fn cni_sweep_find_new_8; /* AVX2, chosen at run time */

/* The state of a running search: sweep_pairs.c plans the searches, sweep_search.c runs them. */
typedef struct cni_sweep_pass {
	cni_sweep *sweep;
	cni_pair_filter_fn *filter;
	const void *filter_context;
	cni_broadphase_pairs *out;
	cni_sweep_find_new_fn *find_new;
	int32_t *touched;      /* tiles with moved proxies, the dense ones first; NULL without scratch */
	int32_t touched_count;
	int32_t dense_count;
	int32_t single_count;  /* moved entries of tiles that are not dense */
	int32_t dense_entries; /* total capacity of the dense tiles whose old boxes are gathered */
	int32_t new_entries;   /* capacity of the largest dense tile whose entries are all new */
	int32_t slot_room;     /* capacity of slots */
	int32_t slot_count;    /* pairs found; only the first slot_room are written */
	float *scratch;        /* +inf and -inf for new entries (2 new_entries), then old boxes of the other dense tiles */
	cni_pair *slots;       /* destination of pairs, NULL: the list. Each worker uses a copy of the pass with its own slots */
} cni_sweep_pass;

static inline int32_t cni_sweep_is_moved(const cni_sweep_pass *pass, int32_t id) { return cni_bit_get(cni_sweep_moved(pass->sweep), id); }

/* Rows of a dense tile's old boxes: in scratch, or, if all entries are new, empty boxes. */
static inline cni_sweep_rows cni_sweep_old_boxes(const cni_sweep_pass *pass, const cni_sweep_tile *tile)
{
	float *least = pass->scratch, *most = least + pass->new_entries;
	cni_sweep_rows empty = { least, most, least, most, NULL };
	return tile->previous == CNI_NONE ? empty : cni_sweep_rows_at(least + 2 * pass->new_entries + tile->previous, tile->capacity);
}

/* The inner loop for the widest vectors of the processor. */
cni_sweep_find_new_fn *cni_sweep_find_new_choose(void);
/* Adds a pair to the list. If the pair is lost, its moved proxy is flagged CNI_PROXY_AGAIN. */
void cni_sweep_pair_list(const cni_sweep_pass *pass, int32_t a, int32_t b);
/* Searches: a dense tile against itself and other tiles, a moved entry against all tiles, loose proxies against everything. */
void cni_sweep_search_tile(cni_sweep_pass *pass, int32_t tile);
void cni_sweep_search_entry(cni_sweep_pass *pass, int32_t id);
void cni_sweep_search_loose(cni_sweep_pass *pass);

/* ---- queries ---- */

static inline const cni_sweep *cni_sweep_of(const cni_broadphase *broadphase) { return (const cni_sweep *)(const void *)broadphase; }

void cni_sweep_query(const cni_broadphase *broadphase, const cni_aabb *box, cni_query_fn *visit, void *context);
void cni_sweep_ray(const cni_broadphase *broadphase, cni_vec2 origin, cni_vec2 translation, cni_query_fn *visit, void *context);

#endif
