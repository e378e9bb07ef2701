/* SPDX-License-Identifier: Apache-2.0 */
/* What a test may have left behind. */
#ifndef TESTS_LEFTOVERS_H
#define TESTS_LEFTOVERS_H

#include <dirent.h>
#include <errno.h>
#include <sys/wait.h>

/* How many things are in a folder, such as /proc/self/fd. */
static size_t count_entries(const char *path)
{
    size_t count = 0;
    DIR *folder = opendir(path);
    assert_non_null(folder);
    for (const struct dirent *e; (e = readdir(folder));)
        count += e->d_name[0] != '.';
    closedir(folder);
    return count;
}

/* No child, running or dead, is left. Sanitizers have one that tells them names. */
static void assert_alone(void)
{
#ifndef MURK_SANITIZED
    assert_int_equal(waitpid(-1, NULL, WNOHANG), -1);
    assert_int_equal(errno, ECHILD);
#endif
}

#endif
