/*
 * model/lane.h - lanes of contact blocks: taking, freeing and moving them. Only model/ uses this;
 * what a lane holds is in contact.h.
 */
#ifndef CNI_MODEL_LANE_H
#define CNI_MODEL_LANE_H

#include "model/contact.h"

/* Rows of a block seen as one array: row r of a lane is rows[r * CNI_LANES + lane]. Rows 0 and 1 are
   the body indices. */
#define CNI_BLOCK_ROWS ((int32_t)(sizeof(cni_contact_block) / (CNI_LANES * sizeof(float))))

#define CNI_ANCHOR_ROWS ((int32_t)(sizeof(cni_block_anchor) / (CNI_LANES * sizeof(float))))

/* Chooses a colour for the contact, marks its bodies and takes a lane; the rows are zero but for the
   body indices. Room must have been reserved. */
void cni_lane_take(cn_world *world, int32_t contact);
/* Frees the contact's lane and fills it with the colour's last one. */
void cni_lane_free(cn_world *world, int32_t contact);
/* The slot's contact began to touch in this step. */
void cni_lane_set_fresh(cn_world *world, int32_t slot);
/* The slot's lane has no anchor any more. */
void cni_lane_invalidate(cn_world *world, int32_t slot);
/* Sets the lane's body indices from the bodies. */
void cni_lane_set_bodies(cn_world *world, const cni_contact *c);

#endif
