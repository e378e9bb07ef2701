/* SPDX-License-Identifier: Apache-2.0 */
/* What every fuzzer defines: libFuzzer calls it with bytes of its own making, replay.c with those
   of files. */
#ifndef FUZZ_FUZZ_H
#define FUZZ_FUZZ_H

#include <stddef.h>
#include <stdint.h>

/* Gives 0. Whatever the bytes, it comes back, and nothing is left allocated. */
int LLVMFuzzerTestOneInput(const uint8_t *bytes, size_t size);

#endif
