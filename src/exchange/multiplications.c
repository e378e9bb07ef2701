/* SPDX-License-Identifier: Apache-2.0 */
#include "multiplications.h"

double murk_multiplications_full(const double n[3])
{
    double zones = n[0] * n[1] * n[2];
    return zones * zones + 2 * zones * n[0] * n[1];
}

double murk_multiplications_window(const double n[3], const double m[3])
{
    double zones = n[0] * n[1] * n[2];
    return zones * m[0] * m[1] * m[2] + 2 * zones * m[0] * m[1];
}
