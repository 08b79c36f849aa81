/*
 * contacts/contact_kernel_plain.c - the contact kernel in plain C, one lane at a time.
 */
#define CNI_WIDTH 1
#define CNI_KERNEL cni_contact_kernel_plain
#include "contacts/contact_kernel.h"
