// SPDX-License-Identifier: Apache-2.0
// Only compiled, as C++17: the public headers can be used from there.
#include "murk/band.h"
#include "murk/bands.h"
#include "murk/contrast.h"
#include "murk/core.h"
#include "murk/deep.h"
#include "murk/exchange.h"
#include "murk/false_color.h"
#include "murk/image.h"
#include "murk/murk.h"
#include "murk/plot.h"

namespace
{
struct release {
    void operator()(murk_context *context) const
    {
        murk_context_release(context);
    }
};
} // namespace

extern murk_status (*const header_solve)(murk_context *, const murk_scene *,
                                         const murk_solve_options *, murk_solution **);
decltype(header_solve) header_solve = murk_solve;
extern const murk_exchange_method *header_method;
const murk_exchange_method *header_method = nullptr;
void header_release(murk_context *context);
void header_release(murk_context *context)
{
    release{}(context);
}
