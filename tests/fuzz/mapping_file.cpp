// Fuzzes mapping files. Accepted ones name a pose or frames.
#include "core/mapping/mapping.h"

#include <cmath>
#include <cstdint>

#include "tests/fuzz/promise.h"

using namespace terratact;
using namespace terratact::fuzz;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    const auto mapping = mappingFrom("f", textOf(data, size));
    if (!mapping) return promiseRefusal(mapping.error(), "f"), 0;
    promise(mapping->frames || mapping->attitude || mapping->of(Quantity::Pitch),
            "a mapping has a pose or frames");
    for (const auto& source : mapping->fields)
        if (source)
            promise(std::isfinite(source->factor) && !source->field.empty(),
                    "a field has a factor");
    promise(mapping->maxGap > 0.0 && mapping->rate >= 0.0, "times are positive");
    return 0;
}
