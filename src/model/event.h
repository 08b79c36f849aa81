/*
 * model/event.h - logs of contact, sensor and joint events.
 *
 * Stages and calls log compact records. The public arrays are built from them on the first request, so that events without a
 * reader cost 28 bytes and nothing more. The impulses of an ENTER are in the anchor of its lane (cni_block_anchor). A HIT is logged
 * in its public form, with its point: the pair may be gone when it is read.
 *
 *   log[kind]      the last step's
 *   pending[kind]  since then, by calls      (LEAVE, DESTROYED): the next step starts with them
 *   seen[kind]     the built public arrays
 */
#ifndef CNI_MODEL_EVENT_H
#define CNI_MODEL_EVENT_H

#include "base/table.h"
#include "cairn.h"

typedef struct cni_event {
	cn_shape shape_a, shape_b;
	cn_body body_a, body_b;
	int32_t child;          /* of shape a, or ~child of shape b: at most one of the two is a chain */
	int32_t contact;
	float approach_speed;
} cni_event;

/* A STAY in its log. Contacts begin in steps only, so that until the next one the record holds this contact or none. */
typedef struct cni_event_stay {
	int32_t contact;
	float normal_impulse, friction_impulse; /* of the step */
} cni_event_stay;

/* Sums of a contact over a step. */
typedef struct cni_event_sums {
	float normal, friction; /* impulses */
	float approach;         /* of the fastest blow, m/s */
	int32_t point;          /* ... its point: 0 or 1 */
} cni_event_sums;

typedef struct cni_events {
	cni_array log[CN_EVENT_KINDS];
	cni_array pending[CN_EVENT_KINDS];
	cni_array seen[CN_EVENT_KINDS];     /* cn_contact_event */
	int32_t built[CN_EVENT_KINDS];
	cn_contact_event_fn *callback[CN_EVENT_KINDS];
	void *callback_user[CN_EVENT_KINDS];
	cni_array sensor_log;               /* cn_sensor_event of the last step */
	cni_array sensor_pending;           /* since then, by calls */
	cni_array joint_log;                /* cn_joint_event of the last step */
	cni_array joint_pending;            /* since then, by calls */
	cni_array moved;                    /* cn_body_moved, built on request */
	cni_array asleep;                   /* cn_body that fell asleep in the last step */
	int32_t moved_built;
	int32_t in_step;                    /* 1 while a step runs: events go to log[], else to pending[] */
} cni_events;

/* The arrays that were built from the logs are void. */
void cni_events_forget_built(cni_events *events);
/* At the beginning of a step: pending logs become the logs, built arrays become invalid. */
void cni_events_begin_step(cni_events *events);
/* Makes room for an event in a log; NULL: no memory, with a warning. */
void *cni_event_add(cn_world *world, cni_array *log);
/* Logs a contact's event if the contact reports that kind; 0: no memory. */
int32_t cni_event_log(cn_world *world, int32_t contact, int32_t kind);
/* STAY, if the contact reports it and does not enter in this step. */
void cni_event_log_stay(cn_world *world, int32_t contact, const cni_event_sums *sums);
void cni_event_log_hit(cn_world *world, int32_t contact, const cni_event_sums *sums);
int32_t cni_sensor_event_log(cn_world *world, int32_t contact, int32_t kind);
/* Builds the public array of a kind. */
cn_result cni_events_build(cn_world *world, int32_t kind);

#endif
