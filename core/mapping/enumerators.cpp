#include "core/mapping/enumerators.h"

#include "core/robot/measurement.h"

namespace terratact {

std::optional<double> enumeratorOf(Quantity quantity, const std::string& text)
{
    const auto find = [&text](auto last) -> std::optional<double> {
        using Enum = decltype(last);
        for (int i = 0; i <= static_cast<int>(last); ++i)
            if (describe(static_cast<Enum>(i)).english == text) return i;
        return std::nullopt;
    };
    if (quantity == Quantity::Activity) return find(RobotActivity::Stopped);
    return find(Refusal::OutOfLimits);
}

}  // namespace terratact
