#include "core/mapping/mapping_proposal.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <optional>
#include <string_view>
#include <utility>

#include "core/base/text.h"
#include "core/mapping/mapping.h"

namespace terratact {
namespace {

/// A topic and one of its fields.
struct ProposedField {
    const TopicSurvey* topic = nullptr;
    const FieldSurvey* field = nullptr;
};

/// Returns a text in the quotes of TOML.
std::string tomlText(std::string_view text)
{
    std::string out = "\"";
    for (const char c : printable(text)) {
        if (c == '"' || c == '\\') out += '\\';
        out += c;
    }
    return out + '"';
}

std::string smallLetters(std::string text)
{
    std::ranges::transform(text, text.begin(), [](char c) {
        return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
    });
    return text;
}

/// Returns the words of a joint's name: "flipper_fl_joint" has flipper, fl, joint.
bool hasWord(std::string_view text, std::string_view word)
{
    for (std::size_t at = text.find(word); at != std::string_view::npos;
         at = text.find(word, at + 1)) {
        const auto isLetter = [&](std::size_t i) {
            return i < text.size() && text[i] >= 'a' && text[i] <= 'z';
        };
        if ((at == 0 || !isLetter(at - 1)) && !isLetter(at + word.size())) return true;
    }
    return false;
}

/// Returns 0 … 3 for front left, front right, rear left, rear right.
std::optional<std::size_t> cornerOf(const std::string& joint)
{
    constexpr std::array<std::string_view, 4> kShort{"fl", "fr", "rl", "rr"};
    for (std::size_t i = 0; i < kShort.size(); ++i)
        if (hasWord(joint, kShort[i])) return i;
    const auto has = [&joint](std::string_view part) {
        return joint.find(part) != std::string::npos;
    };
    const bool front = has("front"), rear = has("rear") || has("back");
    const bool left = has("left"), right = has("right");
    if (front == rear || left == right) return std::nullopt;
    return (rear ? 2U : 0U) + (right ? 1U : 0U);
}

bool isType(const TopicSurvey& survey, std::string_view package, std::string_view type)
{
    const std::string& full = survey.topic.type;
    return full == fmt::format("{}/{}", package, type)
        || full == fmt::format("{}/msg/{}", package, type);
}

class ProposalWriter {
public:
    ProposalWriter(const std::vector<TopicSurvey>& topics, const std::string& mappingName)
        : topics_(topics)
    {
        text_ = fmt::format(
            "# Proposed from the names and types in the file: check each table.\nname = {}\n",
            tomlText(mappingName));
    }

    std::string write()
    {
        if (const TopicSurvey* const frames = topicOfFrames()) {
            text_ += "\n# The frames are the telemetry; every other table would be ignored.\n";
            text_ += fmt::format("[frames]\ntopic = {}\n", tomlText(frames->topic.name));
            if (frames->topic.type.ends_with("/Frame"))  // can_msgs
                text_ += "extended = \"is_extended\"\nremote = \"is_rtr\"\nerror = \"is_error\"\n"
                         "length = \"dlc\"\n";
            return text_;
        }
        findNamed();
        findJoints();
        writeAttitude();
        for (std::size_t q = 0; q < kQuantities; ++q) writeQuantity(static_cast<Quantity>(q));
        writeForces();
        writeOdometry();
        return text_;
    }

private:
    const TopicSurvey* topicOfFrames() const
    {
        for (const TopicSurvey& survey : topics_)
            if (survey.topic.type == "terratact.CanFrame" || isType(survey, "can_msgs", "Frame"))
                return &survey;
        return nullptr;
    }

    const TopicSurvey* topicOfType(std::string_view package, std::string_view type) const
    {
        const TopicSurvey* most = nullptr;
        for (const TopicSurvey& survey : topics_)
            if (isType(survey, package, type) && survey.messages > 0
                && (!most || survey.messages > most->messages))
                most = &survey;
        return most;
    }

    void findNamed()
    {
        for (const TopicSurvey& survey : topics_)
            for (const FieldSurvey& field : survey.fields)
                for (std::size_t q = 0; q < kQuantities; ++q)
                    if (!found_[q].field
                        && smallLetters(field.path) == name(static_cast<Quantity>(q)))
                        found_[q] = {&survey, &field};
    }

    void findJoints()
    {
        constexpr auto kFirstAngle = static_cast<std::size_t>(Quantity::FrontLeft);
        constexpr auto kFirstCurrent = static_cast<std::size_t>(Quantity::FrontLeftCurrent);
        for (const TopicSurvey& survey : topics_)
            for (const FieldSurvey& field : survey.fields) {
                const bool isPosition = field.path.starts_with("position[");
                if (!isPosition && !field.path.starts_with("effort[")) continue;
                const std::string joint = smallLetters(field.path.substr(field.path.find('[')));
                const auto corner = cornerOf(joint);
                const bool isFlipper = joint.find("flip") != std::string::npos
                                    || joint.find("arm") != std::string::npos
                                    || (joint.find("wheel") == std::string::npos
                                        && joint.find("track") == std::string::npos);
                if (!corner || !isFlipper) continue;
                ProposedField& place = found_[(isPosition ? kFirstAngle : kFirstCurrent) + *corner];
                if (!place.field) place = {&survey, &field};
            }
    }

    void writeAttitude()
    {
        if (found_[0].field) return;
        const TopicSurvey* const imu = topicOfType("sensor_msgs", "Imu");
        if (!imu) {
            text_ += "\n# pitch and roll: not found. Give [attitude] with a quaternion, or [pitch] "
                     "and [roll].\n";
            return;
        }
        text_ += fmt::format("\n[attitude]\ntopic = {}\nquaternion = \"orientation\"\n"
                             "mount_rpy_deg = [0.0, 0.0, 0.0]  # of the IMU in the base\n",
                             tomlText(imu->topic.name));
        hasAttitude_ = true;
    }

    static bool isEffort(const FieldSurvey& field) { return field.path.starts_with("effort["); }

    void writeQuantity(Quantity quantity)
    {
        const ProposedField& place = found_.at(static_cast<std::size_t>(quantity));
        if (hasAttitude_ && (quantity == Quantity::Pitch || quantity == Quantity::Roll)) return;
        if (quantity == Quantity::Speed
            && found_[static_cast<std::size_t>(Quantity::Travelled)].field)
            return;
        if (!place.field) {
            const bool isNeeded =
                quantity >= Quantity::FrontLeft && quantity <= Quantity::RearRight;
            if (isNeeded) text_ += fmt::format("\n# [{}]: not found, and needed\n", name(quantity));
            return;
        }
        text_ += fmt::format("\n[{}]  # {:.4g} to {:.4g}\ntopic = {}\nfield = {}\n", name(quantity),
                             place.field->least, place.field->most,
                             tomlText(place.topic->topic.name), tomlText(place.field->path));
        if (isEffort(*place.field)) text_ += "unit = \"N m\"  # torque of one motor\n";
        constexpr double kMoreThanATurn = 6.3;
        const bool isAngle = quantity <= Quantity::RearRight;
        if (isAngle && std::max(-place.field->least, place.field->most) > kMoreThanATurn)
            text_ += "unit = \"deg\"  # the range is larger than a turn in radians\n";
    }

    void writeForces()
    {
        for (const std::string_view table : kForceTables)
            for (const TopicSurvey& survey : topics_) {
                const std::string first = fmt::format("{}[0]", table);
                if (std::ranges::find(survey.fields, first, &FieldSurvey::path)
                    == survey.fields.end())
                    continue;
                text_ += fmt::format("\n[{0}]\ntopic = {1}\nfield = \"{0}\"\n", table,
                                     tomlText(survey.topic.name));
                break;
            }
    }

    void writeOdometry()
    {
        const auto have = [this](Quantity q) {
            return found_[static_cast<std::size_t>(q)].field != nullptr;
        };
        if (have(Quantity::Travelled) || have(Quantity::Turned) || have(Quantity::Speed)) return;
        if (const TopicSurvey* const odometry = topicOfType("nav_msgs", "Odometry"))
            text_ += fmt::format("\n[odometry]\ntopic = {}\nposition = \"pose.pose.position\"\n"
                                 "orientation = \"pose.pose.orientation\"\n",
                                 tomlText(odometry->topic.name));
        else if (const TopicSurvey* const twist = topicOfType("geometry_msgs", "TwistStamped"))
            text_ += fmt::format("\n[speed]\ntopic = {}\nfield = \"twist.linear.x\"\n",
                                 tomlText(twist->topic.name));
    }

    const std::vector<TopicSurvey>& topics_;
    std::array<ProposedField, kQuantities> found_{};
    std::string text_;
    bool hasAttitude_ = false;
};

}  // namespace

std::string proposedMapping(const std::vector<TopicSurvey>& topics, const std::string& name)
{
    return ProposalWriter(topics, name).write();
}

}  // namespace terratact
