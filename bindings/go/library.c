/* The library, as a part of this package: source/cairn.c, or what `make amalgamation` writes. Not with -tags cairn_system. */
//go:build !cairn_system

#include "cairn.c"
