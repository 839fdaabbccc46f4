#include "drivers/gpio_chip.h"

#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <filesystem>

#include "tests/support/temporary_directory.h"

namespace terratact {
namespace {

using namespace std::chrono_literals;

const std::vector<GpioChip> kChips{{"/dev/gpiochip0", "gpiochip0", "pinctrl", 54, 0},
                                   {"/dev/gpiochip1", "gpiochip1", "expander", 8, 0}};
const std::vector<GpioLineInfo> kLines{{"atem", false, ""}, {"approve", true, "gpiomon"},
                                       {"stop", true, ""},  {"", false, ""},
                                       {"twin", false, ""}, {"twin", false, ""}};

GpioRequest asking(const std::string& input, const std::string& output = "")
{
    GpioRequest request;
    request.inputs.push_back({.name = input, .offset = std::nullopt});
    if (!output.empty()) request.outputs.push_back({.name = output, .offset = std::nullopt});
    return request;
}

testing::AssertionResult says(const Error& error, int code,
                              std::initializer_list<std::string_view> parts)
{
    if (error.code != code)
        return testing::AssertionFailure() << "code " << error.code << ": " << error.text;
    for (const std::string_view part : parts)
        if (error.text.find(part) == std::string::npos)
            return testing::AssertionFailure() << "no \"" << part << "\": " << error.text;
    return testing::AssertionSuccess();
}

TEST(GpioChips, areFoundByLabelOrByName)
{
    const auto byLabel = chooseGpioChip(kChips, "expander", "");
    ASSERT_TRUE(byLabel) << byLabel.error().text;
    EXPECT_EQ(byLabel->name, "gpiochip1");
    const auto byName = chooseGpioChip(kChips, "", "gpiochip0");
    ASSERT_TRUE(byName) << byName.error().text;
    EXPECT_EQ(byName->label, "pinctrl");
}

TEST(GpioChips, missingChipErrorListsTheChips)
{
    EXPECT_TRUE(says(chooseGpioChip(kChips, "panel", "").error(), ENODEV,
                     {"labelled 'panel'", "gpiochip0 [pinctrl]", "gpiochip1 [expander]"}));
    EXPECT_TRUE(says(chooseGpioChip(kChips, "", "gpiochip7").error(), ENODEV,
                     {"named 'gpiochip7'", "gpiochip1 [expander]"}));
    EXPECT_TRUE(says(chooseGpioChip({}, "panel", "").error(), ENODEV,
                     {"'panel'", "this computer has none", "/dev/gpiochip*"}));
}

TEST(GpioChips, withTheSameLabelAreToBeNamed)
{
    std::vector<GpioChip> chips = kChips;
    chips[0].label = "expander";
    EXPECT_TRUE(says(chooseGpioChip(chips, "expander", "").error(), EINVAL,
                     {"several", "gpiochip0 [expander], gpiochip1 [expander]", "name"}));
    EXPECT_TRUE(chooseGpioChip(chips, "", "gpiochip1"));
}

TEST(GpioChips, withoutPermissionAreReported)
{
    std::vector<GpioChip> chips = kChips;
    chips.push_back({"/nowhere/gpiochip2", "gpiochip2", "", 0, EACCES});
    EXPECT_TRUE(says(chooseGpioChip(chips, "panel", "").error(), EACCES,
                     {"/nowhere/gpiochip2", "Permission denied"}))
        << "it may be the one";
    EXPECT_TRUE(chooseGpioChip(chips, "expander", "")) << "another than the one asked for";
}

TEST(GpioChips, areDeviceFilesOnly)
{
    const TemporaryDirectory dir;
    dir.write("gpiochip0", "not a chip");
    std::filesystem::create_symlink("gpiochip0", dir.file("gpiochip1"));
    dir.write("other", "");
    EXPECT_TRUE(listGpioChips(dir.file("")).empty());
    EXPECT_TRUE(listGpioChips(dir.file("missing")).empty());
}

TEST(GpioLinePlaces, areFoundByNameOrOffset)
{
    GpioRequest request = asking("stop", "atem");
    request.inputs.push_back({.name = "", .offset = 3U});
    const auto found = placeGpioLines(request, kChips[1], kLines);
    ASSERT_TRUE(found) << found.error().text;
    ASSERT_EQ(found->inputs.size(), 2U);
    EXPECT_EQ(found->inputs[0].offset, 2U);
    EXPECT_EQ(found->inputs[0].name, "stop");
    EXPECT_EQ(found->inputs[1].offset, 3U);
    EXPECT_EQ(found->inputs[1].name, "");
    EXPECT_EQ(found->outputs.at(0).offset, 0U);
    EXPECT_EQ(found->path, "/dev/gpiochip1");
    EXPECT_EQ(found->label, "expander");
}

TEST(GpioLinePlaces, missingLineErrorListsTheNames)
{
    EXPECT_TRUE(says(placeGpioLines(asking("stp"), kChips[1], kLines).error(), ENOENT,
                     {"gpiochip1 [expander]", "'stp'", "atem, approve, stop, twin"}));
    EXPECT_TRUE(says(placeGpioLines(asking("stp"), kChips[1], {{}, {}}).error(), ENOENT,
                     {"no names", "offset"}));
    const std::vector<GpioLineInfo> many(200, {"x", false, ""});
    const std::string text = placeGpioLines(asking("stp"), kChips[1], many).error().text;
    EXPECT_LT(text.size(), 400U) << text;
}

TEST(GpioLinePlaces, refuseWhatIsAmbiguousOrBeyondTheChip)
{
    EXPECT_TRUE(says(placeGpioLines(asking("twin"), kChips[1], kLines).error(), EINVAL,
                     {"several lines", "'twin'", "offset"}));
    EXPECT_TRUE(says(placeGpioLines(asking("atem", "atem"), kChips[1], kLines).error(), EINVAL,
                     {"line 0", "twice"}));
    GpioRequest request = asking("atem");
    request.outputs.push_back({.name = "", .offset = 0U});
    EXPECT_TRUE(says(placeGpioLines(request, kChips[1], kLines).error(), EINVAL, {"twice"}));
    request.outputs[0].offset = 6;
    EXPECT_TRUE(
        says(placeGpioLines(request, kChips[1], kLines).error(), ENOENT, {"no line 6", "0 to 5"}));
}

TEST(GpioWords, nameTheHolderOfALine)
{
    const auto found = placeGpioLines(asking("atem", "approve"), kChips[1], kLines);
    ASSERT_TRUE(found);
    EXPECT_TRUE(says(gpioRefused(EBUSY, *found, kLines), EBUSY,
                     {"line 1", "'approve'", "'gpiomon' holds it"}));
    const auto kernels = placeGpioLines(asking("stop"), kChips[1], kLines);
    EXPECT_TRUE(says(gpioRefused(EBUSY, *kernels, kLines), EBUSY, {"line 2", "the kernel"}));
    const auto nobodys = placeGpioLines(asking("atem"), kChips[1], kLines);
    EXPECT_TRUE(says(gpioRefused(EBUSY, *nobodys, kLines), EBUSY, {"gpioinfo"}));
    EXPECT_TRUE(says(gpioRefused(ENXIO, *nobodys, kLines), ENXIO, {"refused"}));
}

TEST(GpioWords, nameTheCommandThatOpensADeviceFile)
{
    const TemporaryDirectory dir;
    const std::string path = dir.write("gpiochip0", "");
    ASSERT_EQ(::chmod(path.c_str(), 0600), 0);
    EXPECT_TRUE(says(gpioForbidden(path, EACCES), EACCES,
                     {path, "root only", "groupadd", "usermod -aG gpio", "udev/rules.d"}));
    if (::geteuid() != 0) return;               // only root gives a file to another group
    ASSERT_EQ(::chown(path.c_str(), 0, 1), 0);  // group daemon
    ASSERT_EQ(::chmod(path.c_str(), 0660), 0);
    EXPECT_TRUE(says(gpioForbidden(path, EACCES), EACCES, {"sudo usermod -aG daemon root"}));
    EXPECT_TRUE(says(gpioForbidden(path, EMFILE), EMFILE, {path, "Too many open files"}));
}

TEST(GpioWords, reportALostChip)
{
    const GpioFound found{"/dev/gpiochip1", "gpiochip1", "expander", 8, {}, {}};
    EXPECT_TRUE(says(gpioFailed(found, TR_NOOP("core", "reading a level"), ENODEV), ENODEV,
                     {"[expander]", "gone"}));
    EXPECT_TRUE(says(gpioFailed(found, TR_NOOP("core", "reading a level"), EIO), EIO,
                     {"reading a level", "nput/output error"}));
}

TEST(WaitingForGpio, returnsTheReadableDescriptors)
{
    const GpioFound found{"/dev/gpiochip1", "gpiochip1", "expander", 8, {}, {}};
    std::array<int, 2> quiet{}, busy{};
    ASSERT_EQ(::pipe(quiet.data()), 0);
    ASSERT_EQ(::pipe(busy.data()), 0);
    ASSERT_EQ(::write(busy[1], "x", 1), 1);
    const std::array<int, 2> both{quiet[0], busy[0]};
    const auto ready = waitForGpio(found, both, 1s);
    ASSERT_TRUE(ready) << ready.error().text;
    EXPECT_EQ(*ready, (std::vector<bool>{false, true}));
    const auto none = waitForGpio(found, {both.data(), 1}, 1ms);
    ASSERT_TRUE(none);
    EXPECT_EQ(*none, (std::vector<bool>{false}));
    ::close(quiet[1]);  // a removed chip also hangs up
    EXPECT_TRUE(says(waitForGpio(found, both, 1s).error(), ENODEV, {"gone"}));
    for (const int descriptor : {quiet[0], busy[0], busy[1]}) ::close(descriptor);
}

}  // namespace
}  // namespace terratact
