/* SPDX-License-Identifier: Apache-2.0 */
#include "plane.h"

#include <string.h>

/* Copies go in runs of this many lines, which no page boundary cuts. */
enum { RUN = 8, COPY_STRIDE = 24, COPY_BAND = MURK_WINDOW * COPY_STRIDE };

static size_t hash_place(int32_t u, int32_t v)
{
    uint64_t h = (uint64_t)(uint32_t)u << 32 | (uint32_t)v;
    h = (h ^ h >> 29) * 0xBF58476D1CE4E5B9u;
    return (size_t)(h ^ h >> 32);
}

/* ---- pages --------------------------------------------------------------------------------- */

static void enter_hash(murk_plane *plane, int32_t page)
{
    size_t i = hash_place(plane->place[page][0], plane->place[page][1]) & plane->bucket_mask;
    while (plane->bucket[i] >= 0)
        i = (i + 1) & plane->bucket_mask;
    plane->bucket[i] = page;
}

static void clear_hash(murk_plane *plane)
{
    for (size_t i = 0; plane->bucket && i <= plane->bucket_mask; i++)
        plane->bucket[i] = -1;
}

static bool grow(murk_plane *plane)
{
    size_t capacity = plane->capacity ? 2 * plane->capacity : 4;
    float **state = murk_alloc(capacity, sizeof *state);
    int32_t(*place)[2] = murk_alloc(capacity, sizeof *place);
    uint64_t *tiles = murk_alloc(capacity, sizeof *tiles);
    int32_t *bucket = murk_alloc(2 * capacity, sizeof *bucket);
    if (!state || !place || !tiles || !bucket) {
        murk_free(state);
        murk_free(place);
        murk_free(tiles);
        murk_free(bucket);
        return false;
    }
    if (plane->capacity) {
        memcpy(state, plane->state, plane->made * sizeof *state);
        memcpy(place, plane->place, plane->count * sizeof *place);
        memcpy(tiles, plane->tiles, plane->count * sizeof *tiles);
    }
    murk_free(plane->state);
    murk_free(plane->place);
    murk_free(plane->tiles);
    murk_free(plane->bucket);
    plane->state = state;
    plane->tiles = tiles;
    plane->place = place;
    plane->bucket = bucket;
    plane->capacity = capacity;
    plane->bucket_mask = 2 * capacity - 1;
    clear_hash(plane);
    for (size_t page = 0; page < plane->count; page++)
        enter_hash(plane, (int32_t)page);
    return true;
}

/* Number of the page at page coordinates, made where it does not exist; -1 without memory. */
static int32_t find_page(murk_plane *plane, int32_t u, int32_t v)
{
    size_t i = hash_place(u, v) & plane->bucket_mask;
    for (int32_t page; (page = plane->bucket[i]) >= 0; i = (i + 1) & plane->bucket_mask)
        if (plane->place[page][0] == u && plane->place[page][1] == v)
            return page;
    if (plane->count == plane->capacity && !grow(plane))
        return -1;
    if (plane->count == plane->made) {
        plane->state[plane->made] =
            murk_alloc_unset((size_t)plane->made_bands * MURK_PAGE_LINES, sizeof(float));
        if (!plane->state[plane->made])
            return -1;
        plane->made++;
    }
    int32_t page = (int32_t)plane->count++;
    plane->place[page][0] = u;
    plane->place[page][1] = v;
    plane->tiles[page] = 0;
    enter_hash(plane, page);
    return page;
}

static int32_t page_of(int32_t line)
{
    return line >> MURK_PAGE_BITS;
}

static int within(int32_t line)
{
    return line & (MURK_PAGE - 1);
}

/* Bits first ... last of 8. */
static uint64_t run_of_bits(int first, int last)
{
    return (0xFFu >> (7 - last)) & (0xFFu << first);
}

/* Lets the lines of a page enter whose tiles the range u0 ... u1, v0 ... v1 meets for the first
   time; the range is cut to the page. */
static void enter_tiles(murk_plane *plane, int32_t page, int32_t u0, int32_t u1, int32_t v0,
                        int32_t v1)
{
    int32_t u = plane->place[page][0] * MURK_PAGE, v = plane->place[page][1] * MURK_PAGE;
    int first_u = u0 > u ? (u0 - u) / MURK_TILE : 0, first_v = v0 > v ? (v0 - v) / MURK_TILE : 0;
    int last_u = u1 < u + MURK_PAGE ? (u1 - u) / MURK_TILE : 7;
    int last_v = v1 < v + MURK_PAGE ? (v1 - v) / MURK_TILE : 7;
    uint64_t row = run_of_bits(first_u, last_u), met = 0;
    for (int tile = first_v; tile <= last_v; tile++)
        met |= row << 8 * tile;
    for (uint64_t fresh = met & ~plane->tiles[page]; fresh; fresh &= fresh - 1) {
        int bit = __builtin_ctzll(fresh), at_u = bit % 8 * MURK_TILE, at_v = bit / 8 * MURK_TILE;
        murk_boundary_enter(plane->boundary, plane->incoming, plane->bands, u + at_u, v + at_v,
                            plane->state[page] + at_v * MURK_PAGE + at_u, MURK_PAGE,
                            MURK_PAGE_LINES, plane->entered);
    }
    plane->tiles[page] |= met;
}

static void free_pages(murk_plane *plane)
{
    for (size_t page = 0; page < plane->made; page++)
        murk_free(plane->state[page]);
    plane->made = 0;
}

bool murk_plane_reset(murk_plane *plane, const murk_boundary *boundary,
                      const murk_incoming *incoming, int bands)
{
    plane->boundary = boundary;
    plane->incoming = incoming;
    plane->bands = bands;
    plane->count = 0;
    if (bands > plane->made_bands) {
        free_pages(plane);
        plane->made_bands = bands;
    }
    memset(plane->entered, 0, sizeof plane->entered);
    clear_hash(plane);
    return plane->capacity || grow(plane);
}

void murk_plane_clear(murk_plane *plane)
{
    free_pages(plane);
    murk_free(plane->state);
    murk_free(plane->place);
    murk_free(plane->tiles);
    murk_free(plane->bucket);
    memset(plane, 0, sizeof *plane);
}

/* ---- windows ------------------------------------------------------------------------------- */

/* Moves a window that lies across pages into its copy, or back. */
static void move(const murk_plane *plane, murk_window *window, bool back)
{
    int32_t first = window->u & ~(RUN - 1);
    for (int32_t u = first; u < window->u + window->columns; u += RUN) {
        int along = page_of(u) - page_of(window->u);
        for (int row = 0; row < window->rows; row++) {
            int32_t v = window->v + row;
            int32_t page = window->page[page_of(v) - page_of(window->v)][along];
            float *there = plane->state[page] + within(v) * MURK_PAGE + within(u);
            float *here = window->copy + row * COPY_STRIDE + u - first;
            for (int b = 0; b < plane->bands; b++, there += MURK_PAGE_LINES, here += COPY_BAND)
                memcpy(back ? there : here, back ? here : there, RUN * sizeof *here);
        }
    }
}

bool murk_plane_open(murk_plane *plane, int32_t u0, int32_t u1, int32_t v0, int32_t v1,
                     murk_window *window)
{
    int32_t pu0 = page_of(u0), pu1 = page_of(u1), pv0 = page_of(v0), pv1 = page_of(v1);
    for (int32_t pv = pv0; pv <= pv1; pv++)
        for (int32_t pu = pu0; pu <= pu1; pu++) {
            int32_t page = find_page(plane, pu, pv);
            if (page < 0)
                return false;
            enter_tiles(plane, page, u0, u1, v0, v1);
            window->page[pv - pv0][pu - pu0] = page;
        }
    window->u = u0;
    window->v = v0;
    window->rows = v1 - v0 + 1;
    window->columns = u1 - u0 + 1;
    window->copied = pu0 != pu1 || pv0 != pv1;
    if (window->copied) {
        window->state = window->copy + (u0 & (RUN - 1));
        window->stride = COPY_STRIDE;
        window->band = COPY_BAND;
        move(plane, window, false);
    } else {
        window->state = plane->state[window->page[0][0]] + within(v0) * MURK_PAGE + within(u0);
        window->stride = MURK_PAGE;
        window->band = MURK_PAGE_LINES;
    }
    return true;
}

void murk_plane_close(const murk_plane *plane, murk_window *window)
{
    if (window->copied)
        move(plane, window, true);
}

bool murk_window_dark(const murk_window *window, int bands, const float *least)
{
    for (int b = 0; b < bands; b++)
        for (int row = 0; row < window->rows; row++) {
            const float *line = window->state + b * window->band + row * window->stride;
            bool light = false;
            for (int i = 0; i < window->columns; i++)
                light |= line[i] > least[b] || line[i] < -least[b];
            if (light)
                return false;
        }
    return true;
}

void murk_plane_leave(const murk_plane *plane, double power_per_line, double *const *patch_power,
                      double *net_power)
{
    double left[MURK_MOST_BANDS] = {0};
    for (size_t page = 0; page < plane->count; page++)
        for (uint64_t met = plane->tiles[page]; met; met &= met - 1) {
            int bit = __builtin_ctzll(met), u = bit % 8 * MURK_TILE, v = bit / 8 * MURK_TILE;
            murk_boundary_leave(plane->boundary, plane->incoming, plane->bands,
                                plane->place[page][0] * MURK_PAGE + u,
                                plane->place[page][1] * MURK_PAGE + v,
                                plane->state[page] + v * MURK_PAGE + u, MURK_PAGE, MURK_PAGE_LINES,
                                power_per_line, patch_power, left);
        }
    for (int b = 0; b < plane->bands; b++)
        net_power[b] += power_per_line * (plane->entered[b] - left[b]);
}
