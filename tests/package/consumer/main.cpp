// SPDX-License-Identifier: Apache-2.0
// C++17: the same.
#include <murk/bands.h>
#include <murk/contrast.h>
#include <murk/exchange.h>
#include <murk/false_color.h>

#include <iostream>
#include <memory>

int main(int argc, char **argv)
{
    murk_context *raw = nullptr;
    if (argc != 2 || murk_context_create(nullptr, &raw))
        return 2;
    std::unique_ptr<murk_context, decltype(&murk_context_release)> context(raw,
                                                                           murk_context_release);
    murk_volume *volume = nullptr;
    if (murk_volume_read(context.get(), argv[1], &volume)) {
        std::cout << murk_context_message(context.get()) << '\n';
        return 1;
    }
    std::cout << murk_volume_grid_count(volume) << " grid\n";
    murk_volume_release(volume);
}
