#include "core/atem/panel_file.h"

#include <gtest/gtest.h>

#include <random>
#include <set>
#include <stdexcept>

#include "tests/support/refusal.h"
#include "tests/support/temporary_directory.h"

namespace terratact {
namespace {

const std::string kExample = TERRATACT_SOURCE_DIR "/resources/panels/example.toml";

struct PanelFile : testing::Test {
    Result<PanelConfig> read(const std::string& content)
    {
        return readPanelFile(dir.write("panel.toml", content));
    }
    std::string changed(const std::string& old, const std::string& with) const
    {
        const std::size_t at = example.find(old);
        if (at == std::string::npos) throw std::invalid_argument("no " + old);
        return std::string(example).replace(at, old.size(), with);
    }
    testing::AssertionResult refuses(const std::string& old, const std::string& with,
                                     std::initializer_list<std::string_view> parts)
    {
        return refused(read(changed(old, with)), dir.file("panel.toml"), parts);
    }
    TemporaryDirectory dir;
    std::string example = contentOf(kExample);
};

TEST_F(PanelFile, exampleIsReadAsWritten)
{
    const auto panel = readPanelFile(kExample);
    ASSERT_TRUE(panel) << panel.error().text;
    EXPECT_EQ(panel->name, "Example panel on a Raspberry Pi's header");
    EXPECT_EQ(panel->chipLabel, "pinctrl-bcm2711");
    EXPECT_EQ(panel->chipName, "");
    const PerContact<std::string> names{{"GPIO5", "GPIO6", "GPIO13", "GPIO19"}};
    for (const PanelContact c : kAllPanelContacts)
        EXPECT_EQ(panel->inputs[c], (PanelInputLine{.line = {names[c], std::nullopt},
                                                    .to = ContactTo::Ground,
                                                    .resistor = PullResistor::Internal}))
            << name(c);
    const std::array<std::string, kPanelOutputs> outputs{"GPIO17", "GPIO27", "GPIO22", "GPIO23"};
    for (std::size_t i = 0; i < kPanelOutputs; ++i)
        EXPECT_EQ(panel->outputs[i],
                  (PanelOutputLine{.line = {outputs[i], std::nullopt}, .litWhenLow = false}));
}

TEST_F(PanelFile, mayNameTheChipAndPlaceALineByItsOffset)
{
    std::string content = changed("label = \"pinctrl-bcm2711\"", "name = \"gpiochip4\"");
    content.replace(content.find("line = \"GPIO19\""), 15, "offset = 1023");
    const auto panel = read(content);
    ASSERT_TRUE(panel) << panel.error().text;
    EXPECT_EQ(panel->chipLabel, "");
    EXPECT_EQ(panel->chipName, "gpiochip4");
    EXPECT_EQ(panel->inputs[PanelContact::Stop].line, (PanelLine{"", 1023U}));
}

TEST_F(PanelFile, describesTheWiringOfEachLine)
{
    std::string content = changed(R"("GPIO19", closes_to = "ground", resistor = "internal")",
                                  R"("GPIO19", closes_to = "supply", resistor = "external")");
    const std::string buzzer = R"("GPIO23", lit_when = "high")";
    content.replace(content.find(buzzer), buzzer.size(), R"("GPIO23", lit_when = "low")");
    const auto panel = read(content);
    ASSERT_TRUE(panel) << panel.error().text;
    EXPECT_EQ(panel->inputs[PanelContact::Stop].to, ContactTo::Supply);
    EXPECT_EQ(panel->inputs[PanelContact::Stop].resistor, PullResistor::External);
    EXPECT_EQ(panel->inputs[PanelContact::Atem].to, ContactTo::Ground);
    EXPECT_TRUE(panel->outputs[3].litWhenLow);
    EXPECT_FALSE(panel->outputs[0].litWhenLow);
}

TEST_F(PanelFile, refusesWhatItDoesNotUnderstand)
{
    EXPECT_TRUE(refuses("name = \"Ex", "nam = \"Ex", {"name is missing"}));
    EXPECT_TRUE(refuses("atem    =", "attem =", {"inputs.atem is missing"}));
    EXPECT_TRUE(refuses("stop    =", "# stop =", {"inputs.stop is missing"}));
    EXPECT_TRUE(refuses("buzzer       =", "# buzzer =", {"outputs.buzzer is missing"}));
    EXPECT_TRUE(refuses("[chip]", "[chip]\nspeed = 3", {"line ", "chip.speed", "not a known key"}));
    EXPECT_TRUE(refuses("closes_to = \"ground\"", "closes_to = \"earth\"",
                        {"inputs.atem.closes_to", "earth", "\"supply\""}));
    EXPECT_TRUE(refuses("\"internal\" }", "true }", {"inputs.atem.resistor"}));
    EXPECT_TRUE(refuses("\"high\" }", "\"on\" }", {"outputs.link_lamp.lit_when", "\"low\""}));
    EXPECT_TRUE(refuses("line = \"GPIO5\"", "line = \"\"", {"inputs.atem.line", "1 to 100"}));
    EXPECT_TRUE(refuses("line = \"GPIO5\", ", "", {"inputs.atem.line", "not both"}));
    EXPECT_TRUE(refuses("line = \"GPIO5\"", "line = \"GPIO5\", offset = 5", {"not both"}));
    EXPECT_TRUE(refuses("label = ", "name = \"gpiochip0\"\nlabel = ", {"chip", "not both"}));
    EXPECT_TRUE(refuses("[chip]", "[chip]\n[chips]", {"chip"}));
    EXPECT_TRUE(refuses("[inputs]", "[[inputs]]", {"inputs is not a table"}));
}

TEST_F(PanelFile, refusesAnInvalidOffset)
{
    for (const char* offset : {"-1", "1024", "2.5", "nan", "inf", "\"5\"", "true"})
        EXPECT_TRUE(refuses("line = \"GPIO5\"", std::string("offset = ").append(offset),
                            {"inputs.atem.offset"}))
            << offset;
}

TEST_F(PanelFile, refusesALineThatIsUsedTwice)
{
    EXPECT_TRUE(refuses("GPIO19", "GPIO5", {"inputs.stop.line", "before"}));
    EXPECT_TRUE(refuses("GPIO23", "GPIO5", {"outputs.buzzer.line", "before"}));
}

TEST_F(PanelFile, refusesControlCharactersInNames)
{
    // The kernel's interface ends names at the first NUL: this would be GPIO5 again.
    for (const char* end : {"\\u0000x", "\\n", "\\u001b[31m", "\t", "\\u007f"})
        EXPECT_TRUE(refuses("GPIO19", std::string("GPIO5") + end,
                            {"inputs.stop.line", "control character"}))
            << end;
}

TEST_F(PanelFile, survivesEveryTruncation)
{
    for (std::size_t length = 0; length < example.size(); length += 7) {
        const auto panel = read(example.substr(0, length));
        EXPECT_TRUE(panel || !panel.error().text.empty());
    }
}

TEST_F(PanelFile, survivesChangedBytes)
{
    std::mt19937_64 rng(7);
    std::uniform_int_distribution<std::size_t> where(0, example.size() - 1);
    std::uniform_int_distribution<int> what(0, 255);
    for (int i = 0; i < 300; ++i) {
        std::string content = example;
        for (int k = 0; k < 3; ++k) content[where(rng)] = static_cast<char>(what(rng));
        const auto panel = read(content);
        if (!panel) {
            EXPECT_EQ(panel.error().text.find('\n'), std::string::npos) << panel.error().text;
        }
    }
}

}  // namespace
}  // namespace terratact
