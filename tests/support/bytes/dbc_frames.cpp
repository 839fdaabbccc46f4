#include "tests/support/bytes/dbc_frames.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

#include "core/wire/e2e.h"

namespace terratact {

const std::vector<DbcMessage>& dbc()
{
    static const auto file = readDbc(TERRATACT_SOURCE_DIR "/resources/dbc/terratact.dbc");
    return file->messages;
}

const DbcMessage& message(FrameKind kind)
{
    return dbc().at(static_cast<std::size_t>(kind));
}

const DbcMessage& message(std::string_view name)
{
    for (const DbcMessage& m : dbc())
        if (m.name == name) return m;
    throw std::out_of_range(std::string(name));
}

bool isSigned(const DbcSignal& s)
{
    return s.type == DbcSignal::Type::Signed;
}

std::int64_t rawOf(double value, const DbcSignal& s)
{
    return std::llround((value - s.offset) / s.scale);
}

void setBits(CanFrame& frame, const DbcSignal& s, std::int64_t raw)
{
    for (int i = 0; i < s.length; ++i) {
        const int bit = s.start + i;
        const auto mask = static_cast<std::uint8_t>(1U << (bit % 8));
        auto& byte = frame.data.at(static_cast<std::size_t>(bit / 8));
        const bool on = ((static_cast<std::uint64_t>(raw) >> i) & 1U) != 0;
        byte = static_cast<std::uint8_t>(on ? byte | mask : byte & ~mask);
    }
}

double physical(const CanFrame& frame, const DbcSignal& s)
{
    std::int64_t raw = 0;
    for (int i = s.length - 1; i >= 0; --i) {
        const int bit = s.start + i;
        raw = 2 * raw + ((frame.data.at(static_cast<std::size_t>(bit / 8)) >> (bit % 8)) & 1);
    }
    if (isSigned(s) && raw >= (std::int64_t{1} << (s.length - 1)))
        raw -= std::int64_t{1} << s.length;
    return static_cast<double>(raw) * s.scale + s.offset;
}

void seal(CanFrame& frame, const DbcMessage& m, std::uint8_t counter)
{
    protect(std::span(frame.data).first(8), counter,
            static_cast<std::uint16_t>(m.attributes.at("E2eDataId")));
}

CanFrame blank(const DbcMessage& m, std::uint8_t counter)
{
    CanFrame frame{.id = m.id, .length = static_cast<std::uint8_t>(m.length)};
    for (const DbcSignal& s : m.payload)
        if (s.least > 0.0 || s.name == "Sd")
            setBits(frame, s, std::max(rawOf(s.least, s), std::int64_t{1}));
    seal(frame, m, counter);
    return frame;
}

std::optional<FrameFault> faultOf(const CanFrame& frame)
{
    const auto result = unpack(frame);
    const auto* fault = std::get_if<FrameFault>(&result);
    return fault ? std::optional(*fault) : std::nullopt;
}

Unpacked contentOf(const CanFrame& frame)
{
    return std::get<Unpacked>(unpack(frame));
}

}  // namespace terratact
