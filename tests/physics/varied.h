/* SPDX-License-Identifier: Apache-2.0 */
/* Scenes with all that makes one hard: voids, contrast, albedos, hot spots, ground, sun and sky. */
#ifndef VARIED_H
#define VARIED_H

#include "setting.h"

enum { VARIED_SCENES = 5 };

struct varied_scene {
    const char *name;
    void (*make)(struct setting *s);
    long packets; /* for about 0.2 % of noise */
};

extern const struct varied_scene VARIED[VARIED_SCENES];

/* 30 % voids, else 0.02 to 2 optical depths a zone; albedos between the two given. */
void setting_fill_at_random(struct setting *s, double least, double most);

#endif
