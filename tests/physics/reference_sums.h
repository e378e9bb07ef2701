/* SPDX-License-Identifier: Apache-2.0 */
/* What the references share. */
#ifndef REFERENCE_SUMS_H
#define REFERENCE_SUMS_H

#include "references.h"

/* Voxels along an edge, at most. */
enum { MOST_EDGE = 80 };

/* Of a relative L2 norm, and the largest relative difference. */
struct reference_sums {
    double difference, size, most;
};

static inline void reference_add(struct reference_sums *s, double weight, double value,
                                 double wanted)
{
    s->difference += weight * pow(value - wanted, 2);
    s->size += weight * wanted * wanted;
    s->most = fmax(s->most, fabs(value / wanted - 1));
}

static inline struct reference_error reference_result(const struct reference_sums *s, double ground)
{
    return (struct reference_error){sqrt(s->difference / s->size), s->most, ground};
}

#endif
