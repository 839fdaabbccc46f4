#include "app/modelling/truth/truth_cells.h"

#include <bit>
#include <cstring>

namespace terratact {
namespace {

static_assert(std::endian::native == std::endian::little, "cells are stored as they lie in memory");
static_assert(sizeof(float) == 4);

template <class Value>
void addValues(std::string& bytes, const std::vector<Value>& values)
{
    bytes.append(reinterpret_cast<const char*>(values.data()), values.size() * sizeof(Value));
}

/// Takes `count` values off the begin of the bytes.
template <class Value>
std::vector<Value> taken(std::string_view& bytes, std::size_t count)
{
    std::vector<Value> values(count);
    if (count > 0) std::memcpy(values.data(), bytes.data(), count * sizeof(Value));
    bytes.remove_prefix(count * sizeof(Value));
    return values;
}

}  // namespace

std::string storedCells(const PlaceCells& cells)
{
    std::string bytes;
    addValues(bytes, std::vector{cells.most, static_cast<std::uint32_t>(cells.counts.size())});
    addValues(bytes, cells.counts);
    addValues(bytes, cells.ceilings);
    addValues(bytes, cells.heights);
    return bytes;
}

std::optional<PlaceCells> cellsFrom(const std::string& bytes)
{
    std::string_view left = bytes;
    if (left.size() < 8 || left.size() % 4 != 0) return std::nullopt;
    const auto head = taken<std::uint32_t>(left, 2);
    if (left.size() / 8 < head[1]) return std::nullopt;
    PlaceCells cells{.most = head[0]};
    cells.counts = taken<std::uint32_t>(left, head[1]);
    cells.ceilings = taken<float>(left, head[1]);
    cells.heights = taken<float>(left, left.size() / 4);
    return cells;
}

}  // namespace terratact
