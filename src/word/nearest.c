/* SPDX-License-Identifier: Apache-2.0 */
#include "nearest.h"

#include <ctype.h>
#include <string.h>

static int least(int a, int b)
{
    return a < b ? a : b;
}

static int differ(char a, char b)
{
    return tolower((unsigned char)a) != tolower((unsigned char)b);
}

/* Optimal string alignment, three rows of its table at a time. */
int murk_edit_distance(const char *a, const char *b)
{
    int rows[3][MURK_EDIT_DISTANCE_MAX + 1];
    int na = (int)strlen(a), nb = (int)strlen(b);
    if (na > MURK_EDIT_DISTANCE_MAX || nb > MURK_EDIT_DISTANCE_MAX)
        return MURK_EDIT_DISTANCE_MAX;
    for (int j = 0; j <= nb; j++)
        rows[0][j] = j;
    for (int i = 1; i <= na; i++) {
        int *row = rows[i % 3], *above = rows[(i + 2) % 3], *above2 = rows[(i + 1) % 3];
        row[0] = i;
        for (int j = 1; j <= nb; j++) {
            row[j] =
                least(least(above[j], row[j - 1]) + 1, above[j - 1] + differ(a[i - 1], b[j - 1]));
            if (i > 1 && j > 1 && !differ(a[i - 1], b[j - 2]) && !differ(a[i - 2], b[j - 1]))
                row[j] = least(row[j], above2[j - 2] + 1);
        }
    }
    return rows[na % 3][nb];
}

void murk_nearest_offer(struct murk_nearest *nearest, const char *unknown, const char *known)
{
    int distance = murk_edit_distance(unknown, known);
    if (nearest->word && distance >= nearest->distance)
        return;
    nearest->word = known;
    nearest->distance = distance;
}
