/* SPDX-License-Identifier: Apache-2.0 */
#include "kernel.h"

#include <string.h>

murk_kernel_fn murk_kernel_portable;
#ifdef MURK_KERNEL_X86
murk_kernel_fn murk_kernel_avx2, murk_kernel_avx512;
#endif

murk_status murk_kernel_choose(murk_context *context, murk_kernel_fn **kernel, const char **name)
{
    const struct {
        const char *name;
        murk_kernel_fn *kernel;
        bool runs;
    } kernels[] = {
#ifdef MURK_KERNEL_X86
        {"avx512", murk_kernel_avx512,
         __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq") &&
             __builtin_cpu_supports("avx512bw") && __builtin_cpu_supports("avx512vl")},
        {"avx2", murk_kernel_avx2, __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma")},
#endif
        {"portable", murk_kernel_portable, true},
    };
    for (size_t i = 0; i < sizeof kernels / sizeof *kernels; i++) {
        bool asked = context->kernel && !strcmp(context->kernel, kernels[i].name);
        if (context->kernel ? !asked : !kernels[i].runs)
            continue;
        if (!kernels[i].runs)
            break;
        *kernel = kernels[i].kernel;
        *name = kernels[i].name;
        return MURK_OK;
    }
    return murk_fail(context, MURK_ERROR_INPUT,
                     "kernel: this processor cannot run %s; leave it out", context->kernel);
}
