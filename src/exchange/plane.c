/* SPDX-License-Identifier: Apache-2.0 */
#include "plane.h"

#include <string.h>

/* Copies go in runs of this many lines, which no page boundary cuts. */
enum { RUN = 8, COPY_STRIDE = 24 };

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
    size_t capacity = plane->capacity ? 2 * plane->capacity : 8;
    float *state = murk_alloc(capacity * MURK_PAGE_LINES, sizeof *state);
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
    if (plane->count) {
        memcpy(state, plane->state, plane->count * MURK_PAGE_LINES * sizeof *state);
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
    int32_t page = (int32_t)plane->count++;
    plane->place[page][0] = u;
    plane->place[page][1] = v;
    plane->tiles[page] = 0;
    enter_hash(plane, page);
    return page;
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
        plane->entered += murk_boundary_enter(
            plane->boundary, plane->incoming, u + at_u, v + at_v, MURK_TILE,
            plane->state + (size_t)page * MURK_PAGE_LINES + at_v * MURK_PAGE + at_u, MURK_PAGE);
    }
    plane->tiles[page] |= met;
}

bool murk_plane_reset(murk_plane *plane, const murk_boundary *boundary,
                      const murk_incoming *incoming)
{
    plane->boundary = boundary;
    plane->incoming = incoming;
    plane->count = 0;
    plane->entered = 0;
    clear_hash(plane);
    return plane->capacity || grow(plane);
}

void murk_plane_clear(murk_plane *plane)
{
    murk_free(plane->state);
    murk_free(plane->place);
    murk_free(plane->tiles);
    murk_free(plane->bucket);
    memset(plane, 0, sizeof *plane);
}

/* ---- windows ------------------------------------------------------------------------------- */

static float *line_state(murk_plane *plane, int32_t page, int32_t u, int32_t v)
{
    return plane->state + (size_t)page * MURK_PAGE_LINES + (v & (MURK_PAGE - 1)) * MURK_PAGE +
           (u & (MURK_PAGE - 1));
}

static int32_t page_of(int32_t line)
{
    return line >> 6;
}

/* Moves a window that lies across pages into its copy, or back. */
static void move(murk_plane *plane, murk_window *window, bool back)
{
    for (int run = 0; run < window->runs; run++) {
        int32_t u = window->u + run * RUN, last = INT32_MIN, page = -1;
        for (int row = 0; row < window->rows; row++) {
            int32_t v = window->v + row;
            if (page < 0 || page_of(v) != last) {
                last = page_of(v);
                page = find_page(plane, page_of(u), last);
            }
            float *there = line_state(plane, page, u, v);
            float *here = window->copy + row * COPY_STRIDE + run * RUN;
            memcpy(back ? there : here, back ? here : there, RUN * sizeof *here);
        }
    }
}

bool murk_plane_open(murk_plane *plane, int32_t u0, int32_t u1, int32_t v0, int32_t v1,
                     murk_window *window)
{
    int32_t pu0 = page_of(u0), pu1 = page_of(u1), pv0 = page_of(v0), pv1 = page_of(v1);
    int32_t page = -1;
    for (int32_t pv = pv0; pv <= pv1; pv++)
        for (int32_t pu = pu0; pu <= pu1; pu++) {
            page = find_page(plane, pu, pv);
            if (page < 0)
                return false;
            enter_tiles(plane, page, u0, u1, v0, v1);
        }
    window->copied = pu0 != pu1 || pv0 != pv1;
    if (!window->copied) {
        window->state = line_state(plane, page, u0, v0);
        window->stride = MURK_PAGE;
        return true;
    }
    window->u = u0 & ~(RUN - 1);
    window->v = v0;
    window->rows = v1 - v0 + 1;
    window->runs = ((u1 & ~(RUN - 1)) - window->u) / RUN + 1;
    window->state = window->copy + (u0 - window->u);
    window->stride = COPY_STRIDE;
    move(plane, window, false);
    return true;
}

void murk_plane_close(murk_plane *plane, murk_window *window)
{
    if (window->copied)
        move(plane, window, true);
}

double murk_plane_leave(const murk_plane *plane, double power_per_line, double *patch_power)
{
    double left = 0;
    for (size_t page = 0; page < plane->count; page++)
        for (uint64_t met = plane->tiles[page]; met; met &= met - 1) {
            int bit = __builtin_ctzll(met), u = bit % 8 * MURK_TILE, v = bit / 8 * MURK_TILE;
            left += murk_boundary_leave(plane->boundary, plane->incoming,
                                        plane->place[page][0] * MURK_PAGE + u,
                                        plane->place[page][1] * MURK_PAGE + v, MURK_TILE,
                                        plane->state + page * MURK_PAGE_LINES + v * MURK_PAGE + u,
                                        MURK_PAGE, power_per_line, patch_power);
        }
    return power_per_line * (plane->entered - left);
}
