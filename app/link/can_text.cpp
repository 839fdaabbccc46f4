#include "app/link/can_text.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <variant>

#include "core/wire/absolem.h"
#include "core/wire/absolem_text.h"
#include "core/wire/can_codec.h"
#include "core/wire/can_error.h"
#include "core/wire/dbc/dbc_text.h"
#include "core/wire/frame_validator.h"

namespace terratact {
namespace {

// Formats with as many digits as the scale resolves.
std::string number(double value, double scale)
{
    const int digits = scale < 1.0 ? static_cast<int>(std::ceil(-std::log10(scale) - 1e-9)) : 0;
    return fmt::format("{:.{}f}", value == 0.0 ? 0.0 : value, digits);
}

Message commandName(double id)
{
    if (id == 0.0) return TR_NOOP("core", "none");
    const std::optional<FrameKind> kind = kindOfId(static_cast<std::uint32_t>(id));
    return Message::verbatim(kind ? std::string(layoutOf(*kind).name) : number(id, 1.0));
}

/// Returns true for a flag that says nothing: the frame was measured, or a value is not missing.
bool isIdleFlag(std::string_view name, double value)
{
    return name == "Measured" ? value != 0.0 : name.ends_with("Missing") && value == 0.0;
}

/// Returns the values of a frame; a sensor line without measurements has only that statement.
std::vector<NamedValue> valuesOf(const Unpacked& content)
{
    std::vector<NamedValue> values;
    const auto signals = layoutOf(content.kind).payload;
    const auto measured = measuredSignals(content);
    for (std::size_t i = 0; i < signals.size(); ++i) {
        if (!measured[i] || isIdleFlag(signals[i].name, content.values[i])) continue;
        const Message word = wordOf(signals[i], content.values[i]);
        values.push_back({.name = std::string(signals[i].name),
                          .value = word.english(),
                          .unit = std::string(signals[i].unit),
                          .shown = word});
    }
    return values;
}

FrameWords errorWords(const CanFrame& frame)
{
    FrameWords words;
    words.name = "error frame";
    words.verdict = describeError(frame);
    words.trouble = FrameTrouble::Other;
    return words;
}

class TerratactReader final : public FrameReader {
public:
    FrameWords read(const CanFrame& frame, double now) override
    {
        if (frame.error) return errorWords(frame);
        const JudgedFrame judged = judge_.judge(frame, now);
        FrameWords words;
        words.trouble = judged.trouble;
        if (judged.kind) words.name = layoutOf(*judged.kind).name;
        if (judged.fault) {
            words.verdict = *judged.fault == FrameFault::NotClassicData ? kindText(frame)
                                                                        : describe(*judged.fault);
            if (meansStop(frame)) words.verdict += "; a robot still stops";
            return words;
        }
        words.verdict = verdictOf(judged);
        words.counter = judged.content.counter;
        words.values = valuesOf(judged.content);
        return words;
    }

private:
    static std::string verdictOf(const JudgedFrame& judged)
    {
        switch (judged.check) {
        case FrameCheck::Ok:
            if (judged.trouble == FrameTrouble::Gap)
                return fmt::format("ok after {:.3f} s of silence", *judged.silence);
            return "ok";
        case FrameCheck::SomeLost: return "ok, but one or two before it are missing";
        case FrameCheck::Repeated: return "repeated";
        case FrameCheck::WrongSequence: return "out of sequence";
        case FrameCheck::WrongCrc: break;  // unpack() has already handled it
        }
        return describe(FrameFault::WrongCrc);
    }

    FrameValidator judge_;
};

std::string joined(const std::vector<std::string>& phrases)
{
    return phrases.empty() ? "nothing set" : fmt::format("{}", fmt::join(phrases, "; "));
}

class AbsolemReader final : public FrameReader {
public:
    FrameWords read(const CanFrame& frame, double now) override
    {
        if (frame.error) return errorWords(frame);
        const AbsolemListener::Received received = listener_.receive(frame, now);
        FrameWords words;
        words.verdict = received.verdict == AbsolemVerdict::NotClassicData
                          ? kindText(frame)
                          : describe(received.verdict);
        words.trouble = troubleOf(received.verdict);
        if (!received.frame) return words;
        words.name = nameOf(*received.frame);
        words.values = valuesOf(*received.frame, received.verdict);
        return words;
    }

private:
    using Kind = AbsolemFrame::Kind;

    static FrameTrouble troubleOf(AbsolemVerdict verdict)
    {
        switch (verdict) {
        case AbsolemVerdict::Used:
        case AbsolemVerdict::Passed: return FrameTrouble::None;
        case AbsolemVerdict::NotAsked: return FrameTrouble::WrongSequence;
        case AbsolemVerdict::UnknownId:
        case AbsolemVerdict::NotClassicData: return FrameTrouble::Unknown;
        case AbsolemVerdict::WrongLength:
        case AbsolemVerdict::NotACommand:
        case AbsolemVerdict::UnknownCommand:
        case AbsolemVerdict::Refused:
        case AbsolemVerdict::WrongType:
        case AbsolemVerdict::OutOfRange: break;
        }
        return FrameTrouble::Other;
    }

    static std::string nameOf(const AbsolemFrame& frame)
    {
        switch (frame.kind) {
        case Kind::NetworkCommand: return "network command";
        case Kind::StatusWord: return describe(frame.node) + " status";
        case Kind::Query: return describe(frame.node) + " " + frame.name() + "?";
        case Kind::Set: return describe(frame.node) + " " + frame.name() + "=";
        case Kind::Reply: return describe(frame.node) + " " + frame.name();
        }
        return {};
    }

    std::vector<NamedValue> valuesOf(const AbsolemFrame& frame, AbsolemVerdict verdict) const
    {
        switch (frame.kind) {
        case Kind::NetworkCommand:
            return {{"Command",
                     (frame.bits & 0xFFU) == 1 ? "start" : std::to_string(frame.bits & 0xFFU), ""},
                    {"Node", frame.bits >> 8U == 0 ? "all" : std::to_string(frame.bits >> 8U), ""}};
        case Kind::StatusWord:
            return {
                {"Status", joined(statusWordPhrases(static_cast<std::uint16_t>(frame.bits))), ""}};
        case Kind::Query: return {{frame.name(), "?", ""}};
        case Kind::Set:
        case Kind::Reply: break;
        }
        if (verdict == AbsolemVerdict::Refused)
            return {{frame.name(), fmt::format("error {}", frame.bits), ""}};
        std::vector<NamedValue> values{rawValue(frame)};
        if (verdict == AbsolemVerdict::Used) addMeaning(values, frame);
        return values;
    }

    static NamedValue rawValue(const AbsolemFrame& frame)
    {
        const std::string name = frame.name();
        if (frame.isFloat || name == "IQ")
            return {name, fmt::format("{:.3f}", frame.asFloat()), name == "IQ" ? "A" : ""};
        if (name == "SR") return {name, joined(statusRegisterPhrases(frame.bits)), ""};
        if (name == "MF")
            return {name, frame.bits == 0 ? "no fault" : joined(motorFaultPhrases(frame.bits)), ""};
        if (name == "UM") return {name, unitModeWord(frame.bits), ""};
        return {name, std::to_string(frame.asInt()), name == "PX" || name == "PA" ? "counts" : ""};
    }

    // Adds the values that the listener derived, in our units and signs.
    void addMeaning(std::vector<NamedValue>& values, const AbsolemFrame& frame) const
    {
        const AbsolemState& state = listener_.state();
        const AbsolemState::Flipper* flipper = nullptr;
        if (frame.node == AbsolemNode::FrontLeft) flipper = &state.frontLeft;
        if (frame.node == AbsolemNode::FrontRight) flipper = &state.frontRight;
        if (frame.node == AbsolemNode::RearLeft) flipper = &state.rearLeft;
        if (frame.node == AbsolemNode::RearRight) flipper = &state.rearRight;
        const std::string name = frame.name();
        if (name == "PX" && flipper && flipper->angle)
            values.push_back({"angle", number(flipper->angle->value, 1e-4), "rad"});
        if (name == "IQ" && flipper && flipper->current)
            values.push_back({"pressing down", number(flipper->current->value, 1e-3), "A"});
        if (name == "IB[16]")
            values.push_back({"emergency stop", frame.bits != 0 ? "pressed" : "not pressed", ""});
    }

    AbsolemListener listener_;
};

}  // namespace

std::optional<CanProtocol> canProtocolFromName(std::string_view name)
{
    if (name == "terratact") return CanProtocol::Terratact;
    if (name == "absolem") return CanProtocol::Absolem;
    return std::nullopt;
}

std::unique_ptr<FrameReader> frameReader(CanProtocol protocol)
{
    switch (protocol) {
    case CanProtocol::Terratact: return std::make_unique<TerratactReader>();
    case CanProtocol::Absolem: return std::make_unique<AbsolemReader>();
    }
    throw std::invalid_argument("frameReader: no such CanProtocol");
}

Message wordOf(const SignalLayout& signal, double value)
{
    if (signal.name == "Activity") return describe(static_cast<RobotActivity>(value));
    if (signal.name == "Refusal") return describe(static_cast<Refusal>(value));
    if (signal.name == "LastCommand") return commandName(value);
    if (signal.length == 1) return value != 0.0 ? TR_NOOP("core", "yes") : TR_NOOP("core", "no");
    return Message::verbatim(number(value, signal.scale));
}

bool isNotMeasured(const std::vector<NamedValue>& values)
{
    return values.size() == 1 && values[0].name == "Measured" && values[0].value == "no";
}

std::string wordsOf(const std::vector<NamedValue>& values)
{
    if (isNotMeasured(values)) return "not measured";
    std::string text;
    for (const NamedValue& value : values) {
        if (!text.empty()) text += ", ";
        text += value.name;
        text += ' ';
        text += value.value;
        if (!value.unit.empty()) text.append(" ").append(shownDbcText(value.unit));
    }
    return text;
}

std::string contentText(const CanFrame& frame, const FrameWords& words)
{
    if (!words.values.empty()) return wordsOf(words.values);
    const bool isSound = words.counter.has_value();
    return isSound ? "" : bytesText(frame);
}

std::string idText(const CanFrame& frame)
{
    if (frame.error) return fmt::format("error {:03X}", frame.id);
    return fmt::format("{:0{}X}{}{}", frame.id, frame.extended ? 8 : 3, frame.fd ? " FD" : "",
                       frame.remote ? " remote" : "");
}

std::string kindText(const CanFrame& frame)
{
    if (frame.error) return "error frame";
    const char* const kind = frame.remote ? "remote frame" : frame.fd ? "CAN FD frame" : "frame";
    return fmt::format("{}{}", frame.extended ? "extended " : "", kind);
}

std::string bytesText(const CanFrame& frame)
{
    std::string text = fmt::format("[{}]", frame.length);
    if (frame.remote) return text;
    for (const std::uint8_t byte : bytesOf(frame)) text += fmt::format(" {:02X}", byte);
    return text + (frame.isCut ? " …" : "");
}

}  // namespace terratact
