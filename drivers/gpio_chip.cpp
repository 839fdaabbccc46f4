#include "drivers/gpio_chip.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <grp.h>
#include <linux/gpio.h>
#include <poll.h>
#include <pwd.h>
#include <sys/ioctl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <optional>
#include <set>

#include "core/base/system_message.h"
#include "core/base/text.h"

namespace terratact {
namespace {

std::string textOf(const char* name, std::size_t most)
{
    return {name, ::strnlen(name, most)};
}

/// Returns the chip; empty if the file is no GPIO chip.
std::optional<GpioChip> chipOf(const std::filesystem::path& path)
{
    GpioChip chip;
    chip.path = path.string();
    chip.name = path.filename().string();
    const int descriptor = ::open(chip.path.c_str(), O_RDWR | O_CLOEXEC);
    if (descriptor < 0) {
        chip.error = errno;
        return chip;
    }
    gpiochip_info info{};
    const int done = ::ioctl(descriptor, GPIO_GET_CHIPINFO_IOCTL, &info);
    ::close(descriptor);
    if (done < 0) return std::nullopt;
    chip.name = textOf(info.name, sizeof info.name);
    chip.label = textOf(info.label, sizeof info.label);
    chip.lines = info.lines;
    return chip;
}

std::string listed(const std::vector<GpioChip>& chips)
{
    std::vector<std::string> names;
    names.reserve(chips.size());
    for (const GpioChip& chip : chips)
        names.push_back(chip.error != 0
                            ? fmt::format("{} ({})", chip.name, std::strerror(chip.error))
                            : fmt::format("{} [{}]", chip.name, chip.label));
    return fmt::format("{}", fmt::join(names, ", "));
}

bool matches(const GpioChip& chip, const std::string& label, const std::string& name)
{
    return label.empty() ? chip.name == name : chip.error == 0 && chip.label == label;
}

/// Returns "3", or "3 ('stop')".
std::string placeName(const GpioPlace& place)
{
    const std::string offset = std::to_string(place.offset);
    return place.name.empty() ? offset : fmt::format("{} ({})", offset, shown(place.name));
}

/// Returns "gpiochip0 [box]".
std::string chipName(const std::string& name, const std::string& label)
{
    return fmt::format("{} [{}]", name, label);
}

/// Returns the names of the chip's lines, for an error about a missing line.
Message lineNames(const std::vector<GpioLineInfo>& lines)
{
    constexpr std::size_t kMax = 60;
    std::vector<std::string> names;
    for (const GpioLineInfo& line : lines)
        if (!line.name.empty()) names.push_back(line.name);
    if (names.empty()) return TR_NOOP("core", "its lines have no names: give offset instead");
    const bool more = names.size() > kMax;
    if (more) names.resize(kMax);
    return {more ? TR_NOOP("core", "it has %1 and more") : TR_NOOP("core", "it has %1"),
            fmt::format("{}", fmt::join(names, ", "))};
}

Result<GpioPlace> placeByName(const std::string& name, const GpioChip& chip,
                              const std::vector<GpioLineInfo>& lines)
{
    const auto isIt = [&](const GpioLineInfo& line) { return line.name == name; };
    const auto found = std::find_if(lines.begin(), lines.end(), isIt);
    if (found == lines.end())
        return Error{Message(TR_NOOP("core", "%1 has no line named %2: %3"),
                             chipName(chip.name, chip.label), shown(name), lineNames(lines)),
                     ENOENT};
    if (std::find_if(found + 1, lines.end(), isIt) != lines.end())
        return Error{Message(TR_NOOP("core", "%1 has several lines named %2: give offset instead"),
                             chipName(chip.name, chip.label), shown(name)),
                     EINVAL};
    return GpioPlace{static_cast<unsigned>(found - lines.begin()), name};
}

Result<GpioPlace> placeOf(const std::string& name, std::optional<unsigned> offset,
                          const GpioChip& chip, const std::vector<GpioLineInfo>& lines)
{
    if (!name.empty()) return placeByName(name, chip, lines);
    if (offset && *offset < lines.size()) return GpioPlace{*offset, lines[*offset].name};
    return Error{Message(TR_NOOP("core", "%1 has no line %2: it has 0 to %3"),
                         chipName(chip.name, chip.label), offset.value_or(0),
                         static_cast<int>(lines.size()) - 1),
                 ENOENT};
}

std::string groupName(gid_t group)
{
    const ::group* const entry = ::getgrgid(group);
    return entry ? entry->gr_name : std::to_string(group);
}

std::string userName()
{
    const ::passwd* const entry = ::getpwuid(::geteuid());
    return entry ? entry->pw_name : std::to_string(::geteuid());
}

}  // namespace

std::vector<GpioChip> listGpioChips(const std::string& directory)
{
    std::vector<std::filesystem::path> paths;
    std::error_code ignored;
    for (const auto& entry : std::filesystem::directory_iterator(directory, ignored))
        if (entry.path().filename().string().starts_with("gpiochip") && !entry.is_symlink(ignored))
            paths.push_back(entry.path());
    std::sort(paths.begin(), paths.end());
    std::vector<GpioChip> chips;
    for (const auto& path : paths)
        if (auto chip = chipOf(path)) chips.push_back(*std::move(chip));
    return chips;
}

Result<GpioChip> chooseGpioChip(const std::vector<GpioChip>& chips, const std::string& label,
                                const std::string& name)
{
    const bool isNamed = label.empty();
    const std::string wanted = shown(isNamed ? name : label);
    if (chips.empty())
        return Error{Message(isNamed
                                 ? TR_NOOP("core", "no GPIO chip named %1: this computer has none "
                                                   "(no /dev/gpiochip*); plug it in, or load "
                                                   "its driver")
                                 : TR_NOOP("core", "no GPIO chip labelled %1: this computer "
                                                   "has none (no /dev/gpiochip*); plug it "
                                                   "in, or load its driver"),
                             wanted),
                     ENODEV};
    const auto isIt = [&](const GpioChip& chip) { return matches(chip, label, name); };
    const auto found = std::find_if(chips.begin(), chips.end(), isIt);
    if (found == chips.end()) {
        const auto closed = std::find_if(chips.begin(), chips.end(),
                                         [](const GpioChip& chip) { return chip.error != 0; });
        if (closed != chips.end()) return gpioForbidden(closed->path, closed->error);
        return Error{Message(isNamed ? TR_NOOP("core", "no GPIO chip named %1: there is %2")
                                     : TR_NOOP("core", "no GPIO chip labelled %1: there is %2"),
                             wanted, listed(chips)),
                     ENODEV};
    }
    if (found->error != 0) return gpioForbidden(found->path, found->error);
    if (std::find_if(found + 1, chips.end(), isIt) != chips.end())
        return Error{
            Message(isNamed ? TR_NOOP(
                        "core",
                        "several GPIO chips named %1: there is %2; give the chip's name instead")
                            : TR_NOOP("core", "several GPIO chips labelled %1: there is %2; give "
                                              "the chip's name instead"),
                    wanted, listed(chips)),
            EINVAL};
    return *found;
}

Result<GpioFound> placeGpioLines(const GpioRequest& request, const GpioChip& chip,
                                 const std::vector<GpioLineInfo>& lines)
{
    GpioFound found{.path = chip.path,
                    .chip = chip.name,
                    .label = chip.label,
                    .lines = chip.lines,
                    .inputs = {},
                    .outputs = {}};
    std::set<unsigned> used;
    const auto place = [&](const auto& wanted, std::vector<GpioPlace>& places) -> Status {
        auto at = placeOf(wanted.name, wanted.offset, chip, lines);
        if (!at) return at.error();
        if (!used.insert(at->offset).second)
            return Error{Message(TR_NOOP("core", "line %1 of %2 is requested twice"),
                                 placeName(*at), chipName(chip.name, chip.label)),
                         EINVAL};
        places.push_back(*std::move(at));
        return Done{};
    };
    for (const GpioInput& input : request.inputs)
        if (const Status done = place(input, found.inputs); !done) return done.error();
    for (const GpioOutput& output : request.outputs)
        if (const Status done = place(output, found.outputs); !done) return done.error();
    return found;
}

Error gpioRefused(int code, const GpioFound& found, const std::vector<GpioLineInfo>& lines)
{
    const std::string chip = chipName(found.chip, found.label);
    if (code != EBUSY)
        return {
            Message(TR_NOOP("core", "%1: the lines were refused: %2"), chip, systemMessage(code)),
            code};
    for (const auto& places : {found.inputs, found.outputs})
        for (const GpioPlace& place : places) {
            const GpioLineInfo& line = lines.at(place.offset);
            if (!line.used) continue;
            const Message holder = line.holder.empty()
                                     ? TR_NOOP("core", "another program, or the kernel,")
                                     : Message::verbatim(shown(line.holder));
            return {Message(TR_NOOP("core", "line %1 of %2 is in use: %3 holds it; end that "
                                            "program, or wire the panel to another line"),
                            placeName(place), chip, holder),
                    code};
        }
    return {Message(TR_NOOP("core", "%1: a line is in use by another program, or by the kernel; "
                                    "gpioinfo shows which"),
                    chip),
            code};
}

Error gpioForbidden(const std::string& path, int code)
{
    const Message cause = Message::joined(Message::verbatim(path), systemMessage(code));
    struct ::stat status {};
    if (code != EACCES || ::stat(path.c_str(), &status) != 0) return {cause, code};
    const bool groupMay = (status.st_mode & (S_IRGRP | S_IWGRP)) == (S_IRGRP | S_IWGRP);
    if (groupMay && status.st_gid != 0)
        return {
            Message(TR_NOOP("core", "%1: it is open to the group %2; run: %3 (and log in "
                                    "again)"),
                    cause, groupName(status.st_gid),
                    fmt::format("sudo usermod -aG {} {}", groupName(status.st_gid), userName())),
            code};
    return {Message(TR_NOOP("core", "%1: it is open to root only; run: %2 (and restart)"), cause,
                    fmt::format("sudo groupadd -f gpio && sudo usermod -aG gpio {} && echo "
                                "'SUBSYSTEM==\"gpio\", KERNEL==\"gpiochip*\", GROUP=\"gpio\", "
                                "MODE=\"0660\"' | sudo tee /etc/udev/rules.d/60-gpio.rules",
                                userName())),
            code};
}

Error gpioFailed(const GpioFound& found, SourceText action, int code)
{
    const std::string chip = chipName(found.chip, found.label);
    if (code == ENODEV)
        return {Message(TR_NOOP("core", "%1: the chip is gone: unplugged, or its driver was "
                                        "removed"),
                        chip),
                code};
    Message cause = Message::joined(action, systemMessage(code));
    return {Message::joined(Message::verbatim(chip), std::move(cause)), code};
}

Result<std::vector<bool>> waitForGpio(const GpioFound& found, std::span<const int> descriptors,
                                      std::chrono::milliseconds patience)
{
    std::vector<::pollfd> polled;
    for (const int descriptor : descriptors)
        polled.push_back({.fd = descriptor, .events = POLLIN | POLLPRI, .revents = 0});
    std::vector<bool> ready(polled.size(), false);
    if (::poll(polled.data(), polled.size(), static_cast<int>(patience.count())) < 0) {
        if (errno == EINTR) return ready;
        return gpioFailed(found, TR_NOOP("core", "waiting for an edge"), errno);
    }
    for (std::size_t i = 0; i < polled.size(); ++i) {
        if ((polled[i].revents & (POLLERR | POLLHUP | POLLNVAL)) != 0)
            return gpioFailed(found, TR_NOOP("core", "waiting for an edge"), ENODEV);
        ready[i] = (polled[i].revents & (POLLIN | POLLPRI)) != 0;
    }
    return ready;
}

}  // namespace terratact
