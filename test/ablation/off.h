/*
 * test/ablation/off.h - switches what CAIRN_OFF names on again (0) and off (1), between worlds.
 */
#ifndef TEST_ABLATION_OFF_H
#define TEST_ABLATION_OFF_H

void cni_ablation_use(int off);

#endif
