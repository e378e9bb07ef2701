/* SPDX-License-Identifier: Apache-2.0 */
/* Runs a fuzzer over the files of its corpus: for compilers without libFuzzer. */
#include "fuzz.h"

#include <dirent.h>
#include <stdio.h>
#include <stdlib.h>

static int replay(const char *path)
{
    FILE *file = fopen(path, "rb");
    if (!file) {
        perror(path);
        return 1;
    }
    fseek(file, 0, SEEK_END);
    const size_t size = (size_t)ftell(file);
    rewind(file);
    /* As large as the bytes, so that reading beyond them is seen. */
    uint8_t *bytes = malloc(size ? size : 1);
    const int failed = !bytes || fread(bytes, 1, size, file) != size;
    fclose(file);
    if (!failed)
        LLVMFuzzerTestOneInput(bytes, size);
    free(bytes);
    return failed;
}

int main(int argc, char **argv)
{
    int failed = argc != 2, count = 0;
    DIR *folder = failed ? NULL : opendir(argv[1]);
    for (struct dirent *entry; folder && (entry = readdir(folder));) {
        char path[4096];
        if (*entry->d_name == '.')
            continue;
        snprintf(path, sizeof path, "%s/%s", argv[1], entry->d_name);
        failed |= replay(path);
        count++;
    }
    if (folder)
        closedir(folder);
    printf("%d files\n", count);
    return failed || !count;
}
