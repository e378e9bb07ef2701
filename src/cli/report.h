/* SPDX-License-Identifier: Apache-2.0 */
/* What a run came to: one line for people, one JSON object for programs. */
#ifndef CLI_REPORT_H
#define CLI_REPORT_H

#include "job.h"

#include <jansson.h>

/* Tells zones, iterations, error and time, and where the outputs are. */
void cli_report_say(struct cli_job *job, murk_status status);

/* Prints every field of murk_report, the times by stage, inputs and outputs. */
void cli_report_json(const struct cli_job *job, murk_status status);

/* Prints the line of a frame without a report: its status and why (text may be NULL). */
void cli_report_frame(int frame, const char *status, const char *text);

/* Prints and releases an object. */
void cli_print_json(json_t *object);

/* A number, or null where JSON has none. */
json_t *cli_json_number(double number);
/* An array of count numbers. */
json_t *cli_json_numbers(const double *numbers, size_t count);
/* A text, or null. */
json_t *cli_json_text(const char *text);

#endif
