/* SPDX-License-Identifier: Apache-2.0 */
/* How time and memory grow with the number of zones. */
#include "bench.h"
#include "statistics.h"

#include <math.h>

bool cli_bench_fit(const struct cli_bench *bench, int medium, struct cli_bench_fit *out)
{
    double zones[CLI_LIST_MOST], seconds[CLI_LIST_MOST], bytes[CLI_LIST_MOST];
    size_t count = 0;
    for (size_t i = 0; i < bench->count; i++) {
        const struct cli_bench_row *row = &bench->row[i];
        if (row->part != CLI_BENCH_GROWTH || row->medium != medium)
            continue;
        zones[count] = row->outcome.median.zones;
        seconds[count] = row->outcome.median.seconds;
        bytes[count++] = row->outcome.median.peak_bytes;
    }
    out->time = bench_power(zones, seconds, count);
    out->memory = bench_power(zones, bytes, count);
    return !isnan(out->time);
}
