#include "widgets/control/status_header.h"

#include <gtest/gtest.h>

#include <QApplication>
#include <QLabel>
#include <QPushButton>
#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "tests/support/gui.h"
#include "widgets/base/palette.h"
#include "widgets/base/theme.h"

namespace terratact {
namespace {

TEST(Header, stopActsOnThePressAndWithoutQuestion)
{
    StatusHeader header;
    gui::showActive(header);
    int stops = 0;
    QObject::connect(&header, &StatusHeader::stopPressed, [&stops] { ++stops; });
    QTest::mousePress(header.stopButton(), Qt::LeftButton);
    EXPECT_EQ(stops, 1);
    QTest::mouseRelease(header.stopButton(), Qt::LeftButton);
    EXPECT_EQ(stops, 1);
    header.setStop({.state = StopViewState::State::Confirmed});
    EXPECT_TRUE(header.stopButton()->isEnabled());
    EXPECT_TRUE(header.stopButton()->isVisible());
}

TEST(Header, theSourcesNameIsAlwaysThere)
{
    StatusHeader header;
    header.setSource("REPLAY demo.log");
    header.setLink("LINK LOST", Tone::Bad);
    EXPECT_EQ(header.sourceName(), "REPLAY demo.log");
}

TEST(Header, aBadgeHasTheColoursOfItsTone)
{
    applyLook(*qApp);
    StatusHeader header;
    header.resize(1400, 60);
    gui::showActive(header);
    const std::pair<Tone, Fill> badges[]{{Tone::Plain, theme().chip},
                                         {Tone::Good, theme().chipGood},
                                         {Tone::Warning, theme().chipWarning},
                                         {Tone::Bad, theme().chipBad}};
    for (const auto& [tone, fill] : badges) {
        header.setLink("link 20 Hz", tone);
        const auto labels = header.findChildren<QLabel*>();
        const auto badge = std::ranges::find(labels, header.linkText(), &QLabel::text);
        ASSERT_NE(badge, labels.end());
        gui::settle(header);
        const QImage image = gui::painted(**badge);
        EXPECT_GT(gui::pixelsOf(image, fill.area), image.width() * image.height() / 2)
            << static_cast<int>(tone);
        EXPECT_GT(gui::pixelsOf(image, fill.text), 20) << static_cast<int>(tone);
    }
}

TEST(Header, theBusAndTheModelLeaveForWhatMattersMore)
{
    applyLook(*qApp);
    StatusHeader header;
    header.setSource("can0");
    header.setLink("link 20 Hz", Tone::Good);
    header.setRobot("halted", Tone::Plain);
    header.setModel("model default.ttm", Tone::Plain);
    header.resize(1400, 60);
    gui::showActive(header);
    EXPECT_FALSE(header.busButton()->isVisible()) << "the source is none";
    const int least = header.minimumSizeHint().width();
    header.setBus("can0 ACTIVE ≤ 9 %", Tone::Plain, "42 frames/s");
    ASSERT_TRUE(header.busButton()->isVisible());
    EXPECT_GE(header.busButton()->height(), 32);
    EXPECT_EQ(header.minimumSizeHint().width(), least);
    EXPECT_EQ(header.busButton()->accessibleName(), QString::fromUtf8("Bus: can0 ACTIVE ≤ 9 %"));
    EXPECT_EQ(header.busButton()->accessibleDescription(), "42 frames/s");
    const int width = header.busButton()->width();
    header.setBus("can0 ACTIVE ≤ 87 %", Tone::Plain, "412 frames/s");
    QApplication::processEvents();
    EXPECT_EQ(header.busButton()->width(), width) << "the load moves nothing";

    const auto modelIsSeen = [&] {
        for (const QLabel* label : header.findChildren<QLabel*>())
            if (label->text().startsWith("model")) return label->isVisible();
        return false;
    };
    EXPECT_TRUE(modelIsSeen());
    bool busAlone = false;
    for (int pixels = 1400; pixels >= least; pixels -= 20) {
        header.resize(pixels, header.heightFor(pixels));
        QApplication::processEvents();
        EXPECT_EQ(gui::cutText(header), std::vector<std::string>()) << pixels;
        EXPECT_EQ(gui::overlaps(header), std::vector<std::string>()) << pixels;
        busAlone = busAlone || (header.busButton()->isVisible() && !modelIsSeen());
    }
    EXPECT_TRUE(busAlone) << "where there is room for one of them, the model leaves";
    EXPECT_FALSE(header.busButton()->isVisible());
    EXPECT_FALSE(modelIsSeen());

    int asked = 0;
    QObject::connect(&header, &StatusHeader::busRequested, [&asked] { ++asked; });
    header.resize(1400, 60);
    QApplication::processEvents();
    header.busButton()->setFocus(Qt::TabFocusReason);
    QTest::keyClick(header.busButton(), Qt::Key_Space);
    EXPECT_EQ(asked, 1);
}

TEST(Header, badStatesAreVisibleAtEveryWidth)
{
    for (const int letters : {100, 200}) {
        applyLook(*qApp, ThemeName::Day, letters);
        StatusHeader header;
        header.setSource("SIMULATED ROBOT");
        header.setRobot("pressing", Tone::Plain);
        header.setLink("LINK LOST · 300 ms", Tone::Bad);
        header.setModel("model default.ttm", Tone::Plain);
        gui::showActive(header);
        const QPushButton& bus = *header.busButton();
        const int least = header.minimumSizeHint().width();
        for (int pixels = letters * 16; pixels >= least; pixels -= 7) {
            header.setBus("can0 ACTIVE ≤ 9 %", Tone::Plain, "");
            header.resize(pixels, header.heightFor(pixels));
            QApplication::processEvents();
            header.setBus("can0 BUS-OFF ≤ 9 % ! 3 dropped", Tone::Bad, "", "can0 BUS-OFF");
            QApplication::processEvents();
            ASSERT_TRUE(bus.isVisible()) << pixels;
            EXPECT_TRUE(bus.text().startsWith("can0 BUS-OFF"));
            EXPECT_TRUE(header.rect().contains(bus.geometry())) << pixels;
            EXPECT_EQ(gui::cutText(header), std::vector<std::string>()) << pixels;
            EXPECT_EQ(gui::overlaps(header), std::vector<std::string>()) << pixels;
        }
        EXPECT_EQ(bus.text(), "can0 BUS-OFF") << "the rest has gone";
        EXPECT_EQ(bus.accessibleName(), "Bus: can0 BUS-OFF ≤ 9 % ! 3 dropped");
        header.setBus("can0 ACTIVE ≤ 9 %", Tone::Warning, "");
        QApplication::processEvents();
        EXPECT_FALSE(bus.isVisible()) << "a doubt has to wait for room";
    }
    applyLook(*qApp);
}

}  // namespace
}  // namespace terratact
