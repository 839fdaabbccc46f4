#include "core/wire/frame_validator.h"

#include <variant>

#include "core/limits.h"
#include "core/wire/telemetry.h"

namespace terratact {
namespace {

FrameTrouble troubleOf(FrameFault fault)
{
    if (fault == FrameFault::UnknownId || fault == FrameFault::NotClassicData)
        return FrameTrouble::Unknown;
    return fault == FrameFault::WrongCrc ? FrameTrouble::WrongChecksum : FrameTrouble::Other;
}

FrameTrouble troubleOf(FrameCheck check)
{
    switch (check) {
    case FrameCheck::Ok: return FrameTrouble::None;
    case FrameCheck::SomeLost: return FrameTrouble::Gap;
    case FrameCheck::Repeated:
    case FrameCheck::WrongSequence: return FrameTrouble::WrongSequence;
    case FrameCheck::WrongCrc: return FrameTrouble::WrongChecksum;
    }
    return FrameTrouble::Other;
}

/// Unpacks a frame. Returns a fault if it has no content.
std::variant<Unpacked, FrameFault> contentOf(const CanFrame& frame)
{
    if (frame.error) return FrameFault::NotClassicData;
    auto got = unpack(frame);
    const auto* content = std::get_if<Unpacked>(&got);
    if (content && content->kind == FrameKind::RobotStatus && !statusOf(*content))
        return FrameFault::OutOfRange;
    return got;
}

}  // namespace

FrameValidator::FrameValidator()
{
    for (const FrameLayout& layout : frameLayouts()) receivers_.emplace_back(layout.dataId);
}

JudgedFrame FrameValidator::judge(const CanFrame& frame, double now)
{
    JudgedFrame judged;
    const auto got = contentOf(frame);
    if (const auto* fault = std::get_if<FrameFault>(&got)) {
        judged.fault = *fault;
        if (frame.error) {
            judged.trouble = FrameTrouble::Other;
            return judged;
        }
        judged.trouble = troubleOf(*fault);
        if (judged.trouble == FrameTrouble::Unknown) return judged;
        judged.kind = kindOfId(frame.id);
        if (*fault == FrameFault::WrongCrc || *fault == FrameFault::WrongLength)
            receivers_[static_cast<std::size_t>(*judged.kind)].receive({}, now);  // never intact
        return judged;
    }
    judged.content = std::get<Unpacked>(got);
    judged.kind = judged.content.kind;
    E2eReceiver& receiver = receivers_[static_cast<std::size_t>(*judged.kind)];
    judged.silence = receiver.age(now);
    judged.check = receiver.receive(bytesOf(frame), now);
    judged.trouble = troubleOf(judged.check);
    const bool isCyclic = layoutOf(*judged.kind).period > 0.0;
    if (judged.check == FrameCheck::Ok && isCyclic && judged.silence
        && *judged.silence > kLinkLostAfter)
        judged.trouble = FrameTrouble::Gap;
    return judged;
}

}  // namespace terratact
