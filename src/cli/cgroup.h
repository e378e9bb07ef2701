/* SPDX-License-Identifier: Apache-2.0 */
/* Limits that the system sets to the process's control group (cgroup v2). */
#ifndef CLI_CGROUP_H
#define CLI_CGROUP_H

/* The least of a limit over the group and those it is in: "memory.max" [bytes], or "cpu.max"
   [processors], whose two numbers are taken as a quotient. Infinite where there is none. */
double cli_cgroup_limit(const char *name);

#endif
