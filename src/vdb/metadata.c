/* SPDX-License-Identifier: Apache-2.0 */
#include "metadata.h"

#include <stdio.h>
#include <string.h>

enum { COMMON_MAX = 5, FACTS_MAX = 20, KEY_LENGTH = 64, SUN_LENGTH = 128 };

/* What one band has to say. */
typedef struct fact {
    const char *key;
    const char *text; /* NULL: the number holds */
    double number;    /* NaN: not known, and left out */
    bool own;         /* each of several bands has its own, even where they are equal */
} fact;

typedef struct murk_band_facts {
    size_t count;
    fact fact[FACTS_MAX];
    char sun[SUN_LENGTH];
    char key[FACTS_MAX][KEY_LENGTH];
} murk_band_facts;

static void collect_facts(const murk_solution *solution, murk_band_facts *facts)
{
    const murk_report *r = &solution->report;
    const murk_medium *medium = solution->medium;
    const double *d = solution->sun.direction;
    snprintf(facts->sun, sizeof facts->sun, "%.9g %.9g %.9g", d[0], d[1], d[2]);
    const fact all[] = {
        {"method", r->method ? r->method : "", 0, false},
        {"sun_direction", facts->sun, 0, false},
        {"sun_irradiance", NULL, solution->sun.irradiance, true},
        {"sky_radiance", NULL, solution->sky_radiance, true},
        {"extinction_scale", NULL, medium->extinction_scale > 0 ? medium->extinction_scale : NAN,
         false},
        {"voxels", medium->corner ? "corner" : "center", 0, false},
        {"asymmetry", NULL, medium->asymmetry, false},
        {"zones", NULL, (double)r->zones, false},
        {"patches", NULL, (double)r->patches, false},
        {"tolerance", NULL, r->tolerance, false},
        {"error_estimate", NULL, r->estimate, true},
        {"tolerance_reached", r->reached ? "yes" : "no", 0, true},
        {"energy_emitted", NULL, r->energy_emitted, true},
        {"energy_sun", NULL, r->energy_sun, true},
        {"energy_diffuse", NULL, r->energy_diffuse, true},
        {"energy_absorbed", NULL, r->energy_absorbed, true},
        {"energy_escaped", NULL, r->energy_escaped, true},
        {"energy_balance", NULL, r->energy_balance, true},
    };
    facts->count = sizeof all / sizeof *all;
    memcpy(facts->fact, all, sizeof all);
}

static bool is_equal(const fact *a, const fact *b)
{
    return a->text ? !strcmp(a->text, b->text) : a->number == b->number;
}

static void add(murk_metadata *m, const char *name, const char *text, double number)
{
    if (text ? *text : !isnan(number))
        m->entry[m->count++] = (murk_vdb_meta){name, text, number};
}

/* Adds fact n: once, or for each band with its name. */
static void add_fact(murk_metadata *m, const murk_band_set *set, size_t n)
{
    const fact *first = &m->facts[0].fact[n];
    bool once = set->count == 1 || !first->own;
    for (size_t i = 1; i < set->count && once; i++)
        once = is_equal(first, &m->facts[i].fact[n]);
    if (once) {
        add(m, first->key, first->text, first->number);
        return;
    }
    for (size_t i = 0; i < set->count; i++) {
        const fact *f = &m->facts[i].fact[n];
        char *key = m->facts[i].key[n];
        snprintf(key, KEY_LENGTH, "%s_%s", f->key, set->name[i]);
        add(m, key, f->text, f->number);
    }
}

static void list_bands(const murk_band_set *set, char *out)
{
    for (size_t i = 0; i < set->count; i++) {
        const char *name = murk_band_set_name(set, i);
        out += sprintf(out, "%s%s", i ? "," : "", name ? name : "single");
    }
}

murk_status murk_metadata_make(const murk_band_set *set, const char *command, murk_metadata *out)
{
    murk_metadata m = {
        .entry = murk_alloc(COMMON_MAX + FACTS_MAX * set->count, sizeof *m.entry),
        .facts = murk_alloc(set->count, sizeof *m.facts),
        .bands = murk_alloc(set->count, MURK_BAND_NAME_MAX + 1),
    };
    if (!m.entry || !m.facts || !m.bands) {
        murk_metadata_clear(&m);
        return murk_fail(set->solution[0]->context, MURK_ERROR_MEMORY, "metadata: out of memory");
    }
    list_bands(set, m.bands);
    add(&m, "murk_version", MURK_VERSION, 0);
    add(&m, "command", command ? command : "", 0);
    add(&m, "units", "W/m^2", 0);
    add(&m, "convention",
        "radiosity is pi times the isotropic source function; a voxel emits radiosity/pi per unit "
        "optical depth",
        0);
    add(&m, "band", m.bands, 0);
    for (size_t i = 0; i < set->count; i++)
        collect_facts(set->solution[i], &m.facts[i]);
    for (size_t n = 0; n < m.facts[0].count; n++)
        add_fact(&m, set, n);
    *out = m;
    return MURK_OK;
}

void murk_metadata_clear(murk_metadata *metadata)
{
    murk_free(metadata->entry);
    murk_free(metadata->facts);
    murk_free(metadata->bands);
    *metadata = (murk_metadata){0};
}
