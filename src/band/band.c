/* SPDX-License-Identifier: Apache-2.0 */
#include "murk/band.h"

#include <string.h>

bool murk_band_valid(const murk_band *band)
{
    return band->wavelength[0] > 0 && band->wavelength[1] >= band->wavelength[0] &&
           isfinite(band->wavelength[1]);
}

bool murk_band_name_valid(const char *name)
{
    static const char SIGNS[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789_-";
    size_t length = strlen(name);
    return length > 0 && length <= MURK_BAND_NAME_MAX && strspn(name, SIGNS) == length;
}
