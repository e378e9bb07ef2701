/* SPDX-License-Identifier: Apache-2.0 */
/* Only compiled, as C99 and C17: the public headers stand alone and keep to the language. */
#include "murk/band.h"
#include "murk/bands.h"
#include "murk/contrast.h"
#include "murk/core.h"
#include "murk/deep.h"
#include "murk/exchange.h"
#include "murk/false_color.h"
#include "murk/image.h"
#include "murk/murk.h"
#include "murk/plot.h"

extern const void *const header_defaults[];

static const murk_context_options context = MURK_CONTEXT_DEFAULT;
static const murk_medium_options medium = MURK_MEDIUM_DEFAULT;
static const murk_ground_options ground = MURK_GROUND_DEFAULT;
static const murk_solve_options solve = MURK_SOLVE_DEFAULT;
static const murk_write_options write = MURK_WRITE_DEFAULT;
static const murk_render_options render = MURK_RENDER_DEFAULT;
static const murk_image_write_options image = MURK_IMAGE_WRITE_DEFAULT;

const void *const header_defaults[] = {&context, &medium, &ground, &solve, &write, &render, &image};
