/* SPDX-License-Identifier: Apache-2.0 */
/* How murk ends when a signal asks it to: with nothing half written left behind. */
#ifndef CLI_SIGNALS_H
#define CLI_SIGNALS_H

#include <stdbool.h>

/* From now on SIGINT, SIGTERM, SIGHUP and SIGPIPE remove unfinished outputs, clear the progress
   bar, if there may be one, and then end the process as they would have. Signals that whoever
   started murk ignores stay ignored. A file that grows too large is a failure to write, not a
   signal. */
void cli_signals_catch(bool bar);

#endif
