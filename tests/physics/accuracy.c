/* SPDX-License-Identifier: Apache-2.0 */
/* Prints the tables of ACCURACY.md: accuracy [PART], by default all of them. Runs on one thread,
   the Monte Carlo on OMP_NUM_THREADS. */
#include "accuracy.h"

#include <stdio.h>
#include <string.h>

int main(int argc, char **argv)
{
    static const struct {
        const char *name;
        void (*print)(void);
    } parts[] = {{"resolution", accuracy_resolution},
                 {"quadrature", accuracy_quadrature},
                 {"zonal", accuracy_zonal},
                 {"thick", accuracy_thick},
                 {"ground", accuracy_ground}};
    int printed = 0;
    for (size_t n = 0; n < sizeof parts / sizeof *parts; n++)
        if (argc < 2 || !strcmp(argv[1], parts[n].name)) {
            parts[n].print();
            printed++;
        }
    if (!printed)
        fprintf(stderr, "usage: accuracy [resolution|quadrature|zonal|thick|ground]\n");
    return !printed;
}
