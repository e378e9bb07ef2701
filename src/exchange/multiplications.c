/* SPDX-License-Identifier: Apache-2.0 */
#include "multiplications.h"

double murk_multiplications_full(double zones, double patches)
{
    return zones * zones + 2 * patches * zones;
}

double murk_multiplications_window(double zones, double patches, const int m[3])
{
    double across = (double)m[0] * m[1];
    return zones * across * m[2] + (patches > 0 ? 2 * zones * across : 0);
}
