/*
 * model/lane.h - lanes of contact blocks: taking, freeing, moving. Private to model/; contact.h has the layout of a lane.
 */
#ifndef CNI_MODEL_LANE_H
#define CNI_MODEL_LANE_H

#include "model/contact.h"

/* Rows of a block as one array: row r of a lane is rows[r * CNI_LANES + lane]. Rows 0 and 1 are the body indices. */
#define CNI_BLOCK_ROWS ((int32_t)(sizeof(cni_contact_block) / (CNI_LANES * sizeof(float))))

#define CNI_ANCHOR_ROWS ((int32_t)(sizeof(cni_block_anchor) / (CNI_LANES * sizeof(float))))

/* Chooses a colour for the contact, marks its bodies and takes a lane; the rows are zero except for the body indices. Memory must be
   reserved. */
void cni_lane_take(cn_world *world, int32_t contact);
/* Takes a lane for a contact that sleeps, with CNI_SLEEP_IN_BLOCKS; all rows are zero. */
void cni_lane_take_asleep(cn_world *world, int32_t contact);
/* Frees the contact's lane and fills it with the colour's last one. */
void cni_lane_free(cn_world *world, int32_t contact);
/* Marks that the slot's contact began to touch in this step. */
void cni_lane_set_fresh(cn_world *world, int32_t slot);
/* Removes the anchor of the slot's lane; gap and approach speed become 0. */
void cni_lane_invalidate(cn_world *world, int32_t slot);
/* Sets the lane's body indices from the bodies. */
void cni_lane_set_bodies(cn_world *world, const cni_contact *c);

#endif
