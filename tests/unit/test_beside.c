/* SPDX-License-Identifier: Apache-2.0 */
/* Outputs appear whole or not at all, whatever ends the process. */
#define _GNU_SOURCE /* O_TMPFILE */
#include "beside.h"
#include "check.h"

#include <dirent.h>
#include <fcntl.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

struct folder {
    char path[64], file[80];
};

static void make_folder(struct folder *folder)
{
    strcpy(folder->path, "/tmp/murk_beside_XXXXXX");
    assert_non_null(mkdtemp(folder->path));
    snprintf(folder->file, sizeof folder->file, "%s/out.bin", folder->path);
}

static void remove_folder(const struct folder *folder)
{
    unlink(folder->file);
    assert_int_equal(rmdir(folder->path), 0);
}

static int count_files(const struct folder *folder)
{
    DIR *directory = opendir(folder->path);
    int count = 0;
    for (struct dirent *entry; (entry = readdir(directory));)
        count += entry->d_name[0] != '.' || strlen(entry->d_name) > 2;
    closedir(directory);
    return count;
}

static void whole(void **state)
{
    struct folder folder;
    make_folder(&folder);
    for (int n = 0; n < 2; n++) { /* new, and in place of another */
        const char *text = n ? "second" : "first";
        murk_beside beside;
        char found[16] = "";
        assert_int_equal(murk_beside_open(*state, folder.file, &beside), MURK_OK);
        assert_int_equal(murk_beside_write(*state, &beside, text, strlen(text)), MURK_OK);
        assert_int_equal(count_files(&folder), beside.temporary ? 1 + n : n);
        assert_int_equal(murk_beside_finish(*state, &beside), MURK_OK);
        assert_int_equal(count_files(&folder), 1);
        FILE *file = fopen(folder.file, "r");
        assert_non_null(file);
        assert_int_equal(fread(found, 1, sizeof found, file), strlen(text));
        fclose(file);
        assert_string_equal(found, text);
    }
    remove_folder(&folder);
}

static void discarded(void **state)
{
    struct folder folder;
    murk_beside beside;
    make_folder(&folder);
    assert_int_equal(murk_beside_open(*state, folder.file, &beside), MURK_OK);
    assert_int_equal(murk_beside_write(*state, &beside, "half", 4), MURK_OK);
    murk_beside_discard(&beside);
    assert_int_equal(count_files(&folder), 0);
    remove_folder(&folder);
}

/* Killed without warning while it writes. */
static void killed(void **state)
{
    struct folder folder;
    make_folder(&folder);
    int probe = open(folder.path, O_TMPFILE | O_RDWR, 0666);
    if (probe < 0) { /* a file system without files that have no name */
        remove_folder(&folder);
        skip();
    }
    close(probe);
    pid_t child = fork();
    assert_true(child >= 0);
    if (!child) {
        murk_beside beside;
        if (!murk_beside_open(*state, folder.file, &beside))
            murk_beside_write(*state, &beside, "half", 4);
        raise(SIGKILL);
    }
    int status;
    assert_int_equal(waitpid(child, &status, 0), child);
    assert_true(WIFSIGNALED(status));
    assert_int_equal(count_files(&folder), 0);
    remove_folder(&folder);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(whole),
        cmocka_unit_test(discarded),
        cmocka_unit_test(killed),
    };
    return cmocka_run_group_tests(tests, open_context, close_context);
}
