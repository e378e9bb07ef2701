/* SPDX-License-Identifier: Apache-2.0 */
#include "residual.h"

#include "apply.h"

/* From what has arrived in r to what is left of the equations. */
static void finish_residual(const murk_residual *of)
{
    const murk_system *system = of->system;
    const murk_vector *x = of->x, *direct = of->direct, *r = of->r;
#pragma omp parallel for num_threads(system->context->threads) schedule(static)
    for (size_t i = 0; i < system->slots; i++)
        r->zone[i] = murk_system_left(system, i, direct->zone[i], r->zone[i], x ? x->zone[i] : 0);
    for (size_t j = 0; j < system->slopes; j++)
        r->slope[j] = murk_system_left(system, murk_bent_slot(system->bent, j), direct->slope[j],
                                       r->slope[j], x ? x->slope[j] : 0);
    for (size_t i = 0; i < system->patches; i++)
        r->patch[i] =
            direct->patch[i] + system->ground->reflectance[i] * r->patch[i] - (x ? x->patch[i] : 0);
}

/* What is asked of an operator for residuals. */
struct questions {
    murk_radiosity in[2 * MURK_MOST_BANDS];
    murk_incident out[2 * MURK_MOST_BANDS];
    int count;
    int diffuse[MURK_MOST_BANDS]; /* which of them tells the diffuse light of a band */
    double part[MURK_MOST_BANDS]; /* of what it tells */
};

/* The light of sky and ground by itself. Without ground it is that of the sky, the same in all
   bands but for its strength, and where there is none nothing is to be asked. */
static void ask_diffuse(const murk_residual *of, int b, struct questions *asked)
{
    const murk_system *system = of[b].system;
    const double sky = of[b].around->sky;
    asked->diffuse[b] = asked->count;
    asked->part[b] = system->ground || sky > 0;
    for (int a = 0; !system->ground && a < b; a++)
        if (asked->part[a] == 1) {
            asked->diffuse[b] = asked->diffuse[a];
            asked->part[b] = sky / of[a].around->sky;
            return;
        }
    if (!(asked->part[b] > 0))
        return;
    asked->in[asked->count] = asked->in[b];
    asked->in[asked->count].zone = asked->in[asked->count].slope = NULL;
    asked->out[asked->count++] = murk_system_arriving(system, of[b].scratch);
}

murk_status murk_system_residual(murk_residual *of, int bands)
{
    const murk_system *system = of->system;
    struct questions asked = {.count = bands};
    for (int b = 0; b < bands; b++) {
        if (of[b].x)
            asked.in[b] = murk_system_sent(of[b].system, of[b].x);
        asked.in[b].sky = of[b].around->sky;
        asked.in[b].horizon = of[b].around->horizon;
        asked.out[b] = murk_system_arriving(of[b].system, of[b].r);
        if (of[b].scratch)
            ask_diffuse(of, b, &asked);
    }
    murk_status status = murk_apply(system->context, system->method, system->state, asked.in,
                                    asked.out, asked.count);
    for (int b = 0; !status && b < bands; b++) {
        of[b].diffuse =
            asked.part[b] > 0 ? asked.part[b] * asked.out[asked.diffuse[b]].net_power : 0;
        finish_residual(&of[b]);
    }
    return status;
}
