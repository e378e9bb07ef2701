/* SPDX-License-Identifier: Apache-2.0 */
#include "march.h"

#include "blocks.h"
#include "kernel.h"

#include <string.h>

murk_march_fn murk_march_portable;
#ifdef MURK_KERNEL_X86
murk_march_fn murk_march_avx2, murk_march_avx512;
#endif

/* The function compiled for the same instruction set as the sweep's kernel. */
static murk_status choose(murk_context *context, murk_march_fn **out)
{
    const struct {
        const char *name;
        murk_march_fn *function;
    } functions[] = {
#ifdef MURK_KERNEL_X86
        {"avx512", murk_march_avx512},
        {"avx2", murk_march_avx2},
#endif
        {"portable", murk_march_portable},
    };
    murk_kernel_fn *sweep;
    const char *name;
    murk_status status = murk_kernel_choose(context, &sweep, &name);
    for (size_t i = 0; !status && i < sizeof functions / sizeof *functions; i++)
        if (!strcmp(functions[i].name, name))
            *out = functions[i].function;
    return status;
}

murk_status murk_march_create(murk_context *context, const murk_solution *solution, murk_march *out)
{
    murk_march march;
    murk_status status = choose(context, &march.run);
    if (status)
        return status;
    march.blocks = murk_blocks_create(context, solution);
    march.box = murk_boxes_create(context, solution->medium);
    march.medium = (murk_marched){solution->medium->kappa_t, march.blocks, march.box};
    if (!march.blocks || !march.box) {
        murk_march_clear(&march);
        return murk_fail(context, MURK_ERROR_MEMORY, "out of memory for rendering");
    }
    *out = march;
    return MURK_OK;
}

void murk_march_clear(murk_march *march)
{
    murk_free(march->blocks);
    murk_free(march->box);
}

murk_status murk_march_glow(murk_context *context, const murk_solution *solution,
                            const murk_march *march, murk_march *out)
{
    murk_march glow = *march;
    glow.blocks = murk_blocks_glow(context, solution);
    if (!glow.blocks)
        return murk_fail(context, MURK_ERROR_MEMORY, "out of memory for rendering");
    glow.medium.blocks = glow.blocks;
    *out = glow;
    return MURK_OK;
}

static bool grow(murk_trace *trace)
{
    size_t capacity = 2 * trace->capacity + 16 * MURK_BRICK_STEPS;
    if (!murk_enlarge(&trace->passed, trace->count, capacity, sizeof *trace->passed) ||
        (trace->records &&
         !murk_enlarge(&trace->path, trace->count, capacity, sizeof *trace->path)))
        return false;
    trace->capacity = capacity;
    return true;
}

void murk_trace_clear(murk_trace *trace)
{
    murk_free(trace->passed);
    murk_free(trace->path);
}

bool murk_march_light(const murk_march *march, const int32_t *brick, size_t count,
                      murk_packet *packet, murk_trace *trace)
{
    size_t done = 0;
    trace->count = 0;
    while ((done += march->run(&march->medium, brick + done, count - done, packet, trace)) < count)
        if (!grow(trace))
            return false;
    return true;
}

double murk_trace_half(const murk_trace *trace, int lane, double depth)
{
    float half = (float)(depth / 2);
    size_t low = 0, high = trace->count;
    if (!(half > 0))
        return INFINITY;
    while (low < high) {
        size_t middle = low + (high - low) / 2;
        if (trace->passed[middle].depth[lane] < half)
            low = middle + 1;
        else
            high = middle;
    }
    if (low == trace->count) /* in the last step, to rounding */
        low--;
    const murk_passed *in = &trace->passed[low];
    float kappa_t = in->kappa_t[lane];
    return in->t[lane] - (kappa_t > 0 ? (in->depth[lane] - half) / kappa_t : 0);
}
