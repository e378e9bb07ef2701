/* SPDX-License-Identifier: Apache-2.0 */
/* A race between threads of OpenMP: ThreadSanitizer has to end this, or it sees none in murk
 * either. */
#include <stdio.h>

int main(void)
{
    int sum = 0;
#pragma omp parallel for num_threads(2)
    for (int i = 0; i < 1000; i++)
        sum += i;
    printf("%d\n", sum);
    return 0;
}
