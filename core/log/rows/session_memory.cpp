#include "core/log/rows/session_memory.h"

#include <bit>
#include <cmath>
#include <cstdint>

#include "core/log/rows/session_tables.h"

namespace terratact {
namespace {

constexpr std::size_t kOldMemoryNumbers = 2 + 2 * kTrailPlaces + kTrailPlanes * 3 * kTrailBins;
constexpr std::size_t kMemoryNumbers = kOldMemoryNumbers + kTrailPlanes * 3 * kBins;
constexpr double kMaxMemoryNumber = 1e6;  // [m], [rad], [N]
constexpr int kMaxMemoryPresses = 10'000;

template <class Numbers>
void addNumbers(std::string& bytes, const Numbers& numbers)
{
    for (const double number : numbers) addLittleEndian(bytes, number);
}

/// Takes numbers from bytes, and notes whether one is out of range.
class MemoryNumbers {
public:
    explicit MemoryNumbers(std::string_view bytes) : bytes_(bytes) {}

    double next(double least, double most)
    {
        const double value = littleEndianAt(bytes_, at_);
        at_ += sizeof(double);
        isSound_ = isSound_ && value >= least && value <= most;
        return value;
    }
    template <class Numbers>
    void fill(Numbers& numbers, double least = -kMaxMemoryNumber, double most = kMaxMemoryNumber)
    {
        for (double& number : numbers) number = next(least, most);
    }
    /// Reads heights that may be +infinity.
    template <class Numbers>
    void fillOpen(Numbers& numbers)
    {
        for (double& number : numbers) {
            number = next(-kMaxMemoryNumber, std::numeric_limits<double>::infinity());
            isSound_ = isSound_ && (std::isinf(number) || number <= kMaxMemoryNumber);
        }
    }
    /// Reads whole numbers from 0 to most.
    template <class Numbers>
    void fillWhole(Numbers& numbers, std::uint16_t most)
    {
        for (std::uint16_t& number : numbers) {
            const double value = next(0.0, most);
            isSound_ = isSound_ && value == std::floor(value);
            number = isSound_ ? static_cast<std::uint16_t>(value) : std::uint16_t{0};
        }
    }
    bool isSound() const { return isSound_; }

private:
    std::string_view bytes_;
    std::size_t at_ = 0;
    bool isSound_ = true;
};

}  // namespace

std::string bytesOfMemory(const TrailHistory& memory)
{
    std::string bytes;
    bytes.reserve(kMemoryNumbers * sizeof(double));
    addLittleEndian(bytes, memory.way);
    addLittleEndian(bytes, memory.presses);
    addNumbers(bytes, memory.pitch);
    addNumbers(bytes, memory.roll);
    for (const TrailGround& ground : memory.ground)
        for (const auto* numbers : {&ground.lowest, &ground.load, &ground.pressed})
            addNumbers(bytes, *numbers);
    for (const TrailGround& ground : memory.ground) {
        addNumbers(bytes, ground.felt);
        addNumbers(bytes, ground.armHeight);
        addNumbers(bytes, ground.armSd);
    }
    return bytes;
}

std::optional<TrailHistory> memoryFrom(std::string_view bytes)
{
    const std::size_t size = bytes.size();
    if (size != kMemoryNumbers * sizeof(double) && size != kOldMemoryNumbers * sizeof(double))
        return std::nullopt;
    MemoryNumbers numbers(bytes);
    TrailHistory memory;
    memory.way = numbers.next(0.0, kTrailReach);
    const double presses = numbers.next(0.0, kMaxMemoryPresses);
    if (!numbers.isSound() || presses != std::floor(presses)) return std::nullopt;
    memory.presses = static_cast<int>(presses);
    numbers.fill(memory.pitch);
    numbers.fill(memory.roll);
    for (TrailGround& ground : memory.ground) {
        numbers.fillOpen(ground.lowest);
        numbers.fill(ground.load, 0.0);
        numbers.fill(ground.pressed);
    }
    if (size == kMemoryNumbers * sizeof(double))
        for (TrailGround& ground : memory.ground) {
            numbers.fillWhole(ground.felt, kAllCells);
            numbers.fill(ground.armHeight);
            numbers.fill(ground.armSd, 0.0);
        }
    if (!numbers.isSound()) return std::nullopt;
    return memory;
}

}  // namespace terratact
