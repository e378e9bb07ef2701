/* SPDX-License-Identifier: Apache-2.0 */
#include "values.h"

#include <ctype.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

/* A finite number at *text, which is moved behind it. */
static bool number_at(const char **text, double *out)
{
    char *end;
    if (isspace((unsigned char)**text))
        return false;
    *out = strtod(*text, &end);
    if (end == *text || !isfinite(*out))
        return false;
    *text = end;
    return true;
}

/* count numbers with separators between them and nothing else. */
static bool numbers(const char *text, char separator, int count, double *out)
{
    for (int i = 0; i < count; i++) {
        if (i > 0 && *text++ != separator)
            return false;
        if (!number_at(&text, &out[i]))
            return false;
    }
    return *text == '\0';
}

static bool in_range(double value, const struct cli_option *option)
{
    return value >= option->min && value <= option->max;
}

static bool whole_numbers(const char *text, int count, int *out, const struct cli_option *option)
{
    double values[3];
    if (!numbers(text, 'x', count, values))
        return false;
    for (int i = 0; i < count; i++)
        if (!in_range(values[i], option) || values[i] != floor(values[i]))
            return false;
    for (int i = 0; i < count; i++)
        out[i] = (int)values[i];
    return true;
}

bool cli_value_flag(const char *text, void *field, const struct cli_option *option)
{
    (void)text;
    (void)option;
    *(bool *)field = true;
    return true;
}

bool cli_value_text(const char *text, void *field, const struct cli_option *option)
{
    (void)option;
    *(const char **)field = text;
    return *text != '\0';
}

bool cli_value_number(const char *text, void *field, const struct cli_option *option)
{
    double value;
    if (!numbers(text, 0, 1, &value) || !in_range(value, option))
        return false;
    *(double *)field = value;
    return true;
}

bool cli_value_percent(const char *text, void *field, const struct cli_option *option)
{
    double value;
    (void)option;
    if (!number_at(&text, &value))
        return false;
    if (*text == '%') {
        value /= 100.0;
        text++;
    }
    if (*text || !(value > 0.0 && value < 1.0))
        return false;
    *(double *)field = value;
    return true;
}

bool cli_value_bytes(const char *text, void *field, const struct cli_option *option)
{
    static const char UNITS[] = "KMGT";
    double value;
    (void)option;
    if (!number_at(&text, &value))
        return false;
    const char *unit = *text ? strchr(UNITS, toupper((unsigned char)*text)) : NULL;
    if (unit) {
        value = ldexp(value, 10 * (int)(unit - UNITS + 1));
        text++;
        text += *text == 'i' && text[1] == 'B';
    }
    text += *text == 'B';
    if (*text || !(value >= 1 && value < 1e18))
        return false;
    *(double *)field = value;
    return true;
}

bool cli_value_count(const char *text, void *field, const struct cli_option *option)
{
    return whole_numbers(text, 1, field, option);
}

bool cli_value_vector(const char *text, void *field, const struct cli_option *option)
{
    double values[3];
    (void)option;
    if (!numbers(text, ',', 3, values))
        return false;
    memcpy(field, values, sizeof values);
    return true;
}

bool cli_value_range(const char *text, void *field, const struct cli_option *option)
{
    double values[2];
    (void)option;
    if (!numbers(text, ':', 2, values) || !(values[0] < values[1]))
        return false;
    memcpy(field, values, sizeof values);
    return true;
}

bool cli_value_size(const char *text, void *field, const struct cli_option *option)
{
    return whole_numbers(text, 2, field, option);
}

bool cli_value_window(const char *text, void *field, const struct cli_option *option)
{
    return whole_numbers(text, 3, field, option);
}

bool cli_value_list(const char *text, void *field, const struct cli_option *option)
{
    struct cli_list list = {0};
    for (double value; list.count < CLI_LIST_MOST && number_at(&text, &value);) {
        int at = list.count++;
        for (; at > 0 && list.value[at - 1] > value; at--)
            list.value[at] = list.value[at - 1];
        list.value[at] = value;
        if (!in_range(value, option))
            return false;
        if (*text == '\0') {
            *(struct cli_list *)field = list;
            return true;
        }
        if (*text++ != ',')
            return false;
    }
    return false;
}

bool cli_value_set(const char *text, void *field, const struct cli_option *option)
{
    unsigned bits = 0;
    for (;; text++) {
        size_t length = strcspn(text, ",");
        int i = 0;
        while (option->choices[i] &&
               (strlen(option->choices[i]) != length || strncmp(option->choices[i], text, length)))
            i++;
        if (!option->choices[i])
            return false;
        bits |= 1u << i;
        text += length;
        if (*text == '\0')
            break;
    }
    *(unsigned *)field = bits;
    return true;
}

bool cli_value_choice(const char *text, void *field, const struct cli_option *option)
{
    for (int i = 0; option->choices[i]; i++)
        if (!strcmp(text, option->choices[i])) {
            *(int *)field = i;
            return true;
        }
    return false;
}
