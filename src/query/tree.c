/*
 * query/tree.c - cn_tree_*: an AABB tree (broadphase/tree.h) for the game's own use, apart from any world.
 *
 * Owns its memory, the handles of its items and their user data. Failed calls change nothing. Searches only
 * read, so several threads may search at once. A visitor must not change the tree; one that does affects only its
 * own search, which may then visit items twice or not at all: free nodes have no children and the stack is
 * bounded.
 */
#include "base/handles.h"
#include "broadphase/tree.h"
#include "world/error.h"

#include <string.h>

struct cn_tree {
	cni_memory memory;
	cni_tree tree;
	cni_handles items;
	cni_array user_data; /* uint64_t by item */
	float margin;
};

static uint64_t *user_data_of(const cn_tree *tree) { return (uint64_t *)tree->user_data.data; }

/* ---- checks ---- */

static int32_t box_is_good(const cn_aabb *box)
{
	return box != NULL && cni_is_finite2(box->lower_m) && cni_is_finite2(box->upper_m) && box->lower_m.x <= box->upper_m.x &&
	       box->lower_m.y <= box->upper_m.y;
}

/* 0 if the box is invalid or overflows with its margin. */
static int32_t box_with_margin(const cn_tree *tree, const cn_aabb *box, cni_aabb *tight, cni_aabb *fat)
{
	if (!box_is_good(box))
		return 0;
	*tight = cni_aabb_of(box->lower_m, box->upper_m);
	*fat = cni_box_fatten(*tight, tree->margin);
	return cni_is_finite(fat->x0) && cni_is_finite(fat->y0) && cni_is_finite(fat->x1) && cni_is_finite(fat->y1);
}

/* ---- creating and destroying ---- */

cn_result cn_tree_create(float margin_m, cn_alloc_fn *alloc, cn_free_fn *free_hook, void *allocator_user, cn_tree **out_tree)
{
	cni_memory memory;
	cn_tree *tree;
	if (!cni_is_finite(margin_m) || margin_m < 0.0f || (alloc == NULL) != (free_hook == NULL) || out_tree == NULL)
		return CN_ERROR_ARGUMENT;
	cni_memory_init_hooks(&memory, alloc, free_hook, allocator_user);
	tree = (cn_tree *)cni_memory_alloc(&memory, sizeof *tree);
	if (tree == NULL)
		return CN_ERROR_MEMORY;
	memset(tree, 0, sizeof *tree);
	tree->memory = memory;
	tree->margin = margin_m;
	cni_tree_init(&tree->tree);
	cni_handles_init(&tree->items, CNI_KIND_BODY);
	cni_array_init(&tree->user_data, (int32_t)sizeof(uint64_t));
	*out_tree = tree;
	return CN_OK;
}

void cn_tree_destroy(cn_tree *tree)
{
	if (tree == NULL)
		return;
	cni_tree_deinit(&tree->tree, &tree->memory);
	cni_handles_deinit(&tree->items, &tree->memory);
	cni_array_deinit(&tree->user_data, &tree->memory);
	cni_memory memory = tree->memory;
	cni_memory_free(&memory, tree, sizeof *tree);
}

/* ---- items ---- */

/* Reserves memory for one more item; the next take then succeeds. */
static cn_result item_reserve(cn_tree *tree)
{
	cn_result result = cni_handles_reserve(&tree->items, &tree->memory, 1);
	int32_t items = cni_handles_peek(&tree->items) + 1;
	if (result != CN_OK)
		return result;
	if (!cni_tree_reserve(&tree->tree, &tree->memory, items, 0) || !cni_array_reserve(&tree->user_data, &tree->memory, items))
		return CN_ERROR_MEMORY;
	tree->user_data.count = cni_max_i(tree->user_data.count, items);
	return CN_OK;
}

cn_result cn_tree_insert(cn_tree *tree, const cn_aabb *box, uint64_t user_data, uint32_t *out_item)
{
	cni_aabb tight, fat;
	if (tree == NULL || out_item == NULL || !box_with_margin(tree, box, &tight, &fat))
		return CN_ERROR_ARGUMENT;
	cn_result result = item_reserve(tree);
	if (result != CN_OK)
		return result;
	int32_t item = cni_handles_take(&tree->items);
	user_data_of(tree)[item] = user_data;
	cni_tree_insert(&tree->tree, item, &fat);
	*out_item = cni_handles_of(&tree->items, item);
	return CN_OK;
}

cn_result cn_tree_remove(cn_tree *tree, uint32_t item)
{
	if (tree == NULL)
		return CN_ERROR_ARGUMENT;
	int32_t index = cni_handles_find(&tree->items, item);
	if (index == CNI_NONE)
		return CN_ERROR_HANDLE;
	cni_tree_remove(&tree->tree, index);
	cni_handles_release(&tree->items, index);
	return CN_OK;
}

cn_result cn_tree_move(cn_tree *tree, uint32_t item, const cn_aabb *box)
{
	cni_aabb tight, fat;
	if (tree == NULL || !box_with_margin(tree, box, &tight, &fat))
		return CN_ERROR_ARGUMENT;
	int32_t index = cni_handles_find(&tree->items, item);
	if (index == CNI_NONE)
		return CN_ERROR_HANDLE;
	if (!cni_aabb_contains(cni_tree_box(&tree->tree, cni_tree_place(&tree->tree, index)), &tight))
		cni_tree_move(&tree->tree, index, &fat);
	return CN_OK;
}

cn_result cn_tree_get_box(const cn_tree *tree, uint32_t item, cn_aabb *out)
{
	if (tree == NULL || out == NULL)
		return CN_ERROR_ARGUMENT;
	int32_t index = cni_handles_find(&tree->items, item);
	if (index == CNI_NONE)
		return CN_ERROR_HANDLE;
	const cni_aabb *box = cni_tree_box(&tree->tree, cni_tree_place(&tree->tree, index));
	out->lower_m = cni_v(box->x0, box->y0);
	out->upper_m = cni_v(box->x1, box->y1);
	return CN_OK;
}

cn_result cn_tree_get_stats(const cn_tree *tree, int32_t *out_count, int32_t *out_height)
{
	if (tree == NULL || out_count == NULL || out_height == NULL)
		return CN_ERROR_ARGUMENT;
	*out_count = tree->tree.count;
	*out_height = cni_tree_height(&tree->tree);
	return CN_OK;
}

/* ---- searches ---- */

typedef struct tree_visitor {
	const cn_tree *tree;
	cn_tree_query_fn *query;
	cn_tree_ray_fn *ray;
	void *user;
} tree_visitor;

static float visit_query(void *context, int32_t item, float limit)
{
	const tree_visitor *v = (const tree_visitor *)context;
	(void)limit;
	return v->query(cni_handles_of(&v->tree->items, item), user_data_of(v->tree)[item], v->user) != 0 ? 1.0f : 0.0f;
}

static float visit_ray(void *context, int32_t item, float limit)
{
	const tree_visitor *v = (const tree_visitor *)context;
	return v->ray(cni_handles_of(&v->tree->items, item), user_data_of(v->tree)[item], limit, v->user);
}

cn_result cn_tree_query(const cn_tree *tree, const cn_aabb *box, cn_tree_query_fn *visit, void *user)
{
	tree_visitor visitor = { tree, visit, NULL, user };
	if (tree == NULL || visit == NULL || !box_is_good(box))
		return CN_ERROR_ARGUMENT;
	cni_aabb region = cni_aabb_of(box->lower_m, box->upper_m);
	cni_tree_query(&tree->tree, &region, visit_query, &visitor);
	return CN_OK;
}

cn_result cn_tree_cast_ray(const cn_tree *tree, const cn_ray *ray, cn_tree_ray_fn *visit, void *user)
{
	tree_visitor visitor = { tree, NULL, visit, user };
	if (tree == NULL || ray == NULL || visit == NULL || !cni_is_finite2(ray->origin_m) || !cni_is_finite2(ray->translation_m) ||
	    !cni_is_finite2(cni_add(ray->origin_m, ray->translation_m)))
		return CN_ERROR_ARGUMENT;
	cni_tree_ray(&tree->tree, ray->origin_m, ray->translation_m, visit_ray, &visitor);
	return CN_OK;
}
