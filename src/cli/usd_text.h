/* SPDX-License-Identifier: Apache-2.0 */
/* Words of a .usda file. */
#ifndef CLI_USD_TEXT_H
#define CLI_USD_TEXT_H

#include <stdio.h>

/* Writes text between quotes. */
void cli_usd_quote(FILE *stream, const char *text);

/* Writes text as the name of a prim or property: letters, digits and _, no digit first. */
void cli_usd_identifier(FILE *stream, const char *text);

/* Writes (a, b, c). */
void cli_usd_vector(FILE *stream, const double vector[3]);

/* Writes the transform of a prim whose axes x, y and z are unit vectors. */
void cli_usd_transform(FILE *stream, const double axes[3][3], const double origin[3]);

/* The path of a file as seen from the folder of another one, from malloc: "./lit.vdb". NULL with
   errno where a folder is not there. */
char *cli_usd_relative(const char *file, const char *from);

#endif
