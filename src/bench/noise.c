/* SPDX-License-Identifier: Apache-2.0 */
#include "noise.h"

#include <math.h>

double bench_random(uint64_t *state)
{
    uint64_t z = *state += 0x9E3779B97F4A7C15u;
    z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9u;
    z = (z ^ (z >> 27)) * 0x94D049BB133111EBu;
    return (double)((z ^ (z >> 31)) >> 11) * 0x1p-53;
}

/* A value in [-1, 1) for a point of the lattice. */
static double lattice_value(uint32_t x, uint32_t y, uint32_t z, uint32_t seed)
{
    uint32_t h = x * 0x8DA6B343u ^ y * 0xD8163841u ^ z * 0xCB1AB31Fu ^ seed * 0x9E3779B9u;
    h = (h ^ (h >> 16)) * 0x7FEB352Du;
    h = (h ^ (h >> 15)) * 0x846CA68Bu;
    return (double)(int32_t)(h ^ (h >> 16)) * 0x1p-31;
}

static double mix(double a, double b, double t)
{
    return a + (b - a) * t;
}

/* Values of the lattice, interpolated smoothly. */
static double value_noise(const double point[3], uint32_t seed)
{
    uint32_t cell[3];
    double t[3], plane[2];
    for (int a = 0; a < 3; a++) {
        double low = floor(point[a]), part = point[a] - low;
        cell[a] = (uint32_t)(int32_t)low;
        t[a] = part * part * (3 - 2 * part);
    }
    for (uint32_t z = 0; z < 2; z++) {
        double row[2];
        for (uint32_t y = 0; y < 2; y++)
            row[y] = mix(lattice_value(cell[0], cell[1] + y, cell[2] + z, seed),
                         lattice_value(cell[0] + 1, cell[1] + y, cell[2] + z, seed), t[0]);
        plane[z] = mix(row[0], row[1], t[1]);
    }
    return mix(plane[0], plane[1], t[2]);
}

double bench_noise(const double point[3], int octaves, double gain, uint32_t seed)
{
    double sum = 0, amplitude = 1, frequency = 1;
    for (int n = 0; n < octaves; n++) {
        const double at[3] = {frequency * point[0], frequency * point[1], frequency * point[2]};
        sum += amplitude * value_noise(at, seed + (uint32_t)n);
        amplitude *= gain;
        frequency *= 2;
    }
    return sum;
}
