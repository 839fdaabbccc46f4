#include "widgets/control/drive_strip.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numbers>
#include <string>
#include <vector>

#include "app/display/drive_text.h"
#include "app/display/units.h"
#include "tests/support/gui.h"
#include "widgets/base/palette.h"
#include "widgets/base/theme.h"
#include "widgets/control/drive_cell.h"

namespace terratact {
namespace {

constexpr double kDeg = std::numbers::pi / 180.0;

DriveViewState::Angle angle(double degrees, AttitudeLevel level = AttitudeLevel::Level)
{
    return {degrees * kDeg, level, {}, 50.0 * kDeg};
}

FlipperContacts known()
{
    FlipperContacts state;
    for (const Flipper flipper : {Flipper::FrontLeft, Flipper::FrontRight})
        for (auto& element : state.flippers[indexOf(flipper)]) element.force = 0.2;
    return state;
}

FlipperContacts pressed()
{
    FlipperContacts state = known();
    state.flippers[indexOf(Flipper::FrontLeft)][4] = {12.2, true};
    state.flippers[indexOf(Flipper::FrontLeft)][3] = {3.0, true};
    state.flippers[indexOf(Flipper::FrontRight)][5] = {6.0, true};
    return state;
}

struct DriveStripShown : testing::Test {
    static void SetUpTestSuite() { look(); }
    static void look(ThemeName name = ThemeName::Day, int scale = 100)
    {
        applyLook(*qobject_cast<QApplication*>(QApplication::instance()), name, scale);
    }
    DriveStripShown()
    {
        gui::showActive(strip);
        strip.resize(1000, strip.minimumSizeHint().height());
    }
    ~DriveStripShown() override { look(); }
    QString spoken(const QString& name) const
    {
        for (const DriveCell* cell : strip.findChildren<DriveCell*>())
            if (cell->accessibleName() == name) return cell->accessibleDescription();
        return {};
    }
    /// Returns the painted texts, each cell's from top to bottom.
    QStringList painted() const
    {
        QStringList texts;
        for (const DriveCell* cell : strip.findChildren<DriveCell*>())
            for (const DriveCell::Line& line : cell->lines()) texts << line.text;
        return texts;
    }
    QStringList shrunk() const
    {
        QStringList cut;
        for (const DriveCell* cell : strip.findChildren<DriveCell*>())
            if (!cell->fits()) cut << cell->accessibleName();
        return cut;
    }
    DriveStrip strip;
};

TEST_F(DriveStripShown, showsNothingThatIsNotKnown)
{
    strip.setViewState({});
    for (int cell = 0; cell < DriveStrip::kCells; ++cell) {
        EXPECT_EQ(strip.text(static_cast<DriveStrip::Cell>(cell)), "--") << cell;
        EXPECT_EQ(strip.level(static_cast<DriveStrip::Cell>(cell)), "") << cell;
    }
}

TEST_F(DriveStripShown, namesALevelByMarkWordAndFill)
{
    strip.setViewState({.pitch = angle(23.4), .roll = angle(-2.0)});
    EXPECT_EQ(strip.text(DriveStrip::Pitch), QStringLiteral("+23.4°"));
    EXPECT_EQ(strip.caption(DriveStrip::Pitch), "pitch");
    EXPECT_EQ(strip.level(DriveStrip::Pitch), "");
    strip.setViewState(
        {.pitch = angle(26.0, AttitudeLevel::Amber), .roll = angle(-40.0, AttitudeLevel::Red)});
    EXPECT_EQ(strip.caption(DriveStrip::Pitch), "pitch ! STEEP");
    EXPECT_EQ(strip.level(DriveStrip::Pitch), "amber");
    EXPECT_EQ(strip.caption(DriveStrip::Roll), QStringLiteral("roll ✘ DANGER"));
    EXPECT_EQ(strip.level(DriveStrip::Roll), "red");
}

TEST_F(DriveStripShown, fillsACellInEveryTheme)
{
    for (const ThemeName name : {ThemeName::Day, ThemeName::NightRed, ThemeName::HighContrast}) {
        look(name);
        strip.setViewState({.pitch = angle(26.0, AttitudeLevel::Amber),
                            .roll = angle(-40.0, AttitudeLevel::Red),
                            .contact = pressed()});
        const QImage image = gui::painted(strip);
        const auto share = [&](const QColor& colour) {
            int count = 0;
            for (int x = 0; x < image.width(); ++x)
                for (int y = 0; y < image.height(); ++y)
                    count += image.pixelColor(x, y).rgb() == colour.rgb() ? 1 : 0;
            return count / static_cast<double>(image.width() * image.height());
        };
        for (const Fill& fill : {theme().open, theme().blocked, theme().felt})
            EXPECT_GT(share(fill.area), 0.04) << static_cast<int>(name);
    }
}

TEST_F(DriveStripShown, namesTheHardestContactOfEachFlipper)
{
    strip.setViewState({.contact = known()});
    EXPECT_EQ(strip.text(DriveStrip::Contact), "none");
    EXPECT_EQ(strip.caption(DriveStrip::Contact), "contact");
    strip.setViewState({.contact = pressed()});
    EXPECT_EQ(strip.text(DriveStrip::Contact), "L5 R6");
    EXPECT_EQ(strip.caption(DriveStrip::Contact), QStringLiteral("● CONTACT 12 N"));
    EXPECT_EQ(strip.level(DriveStrip::Contact), "contact");
    EXPECT_EQ(spoken("contact"), "left 5: 12.2 N; right 6: 6.0 N");
    strip.setViewState({});
    EXPECT_EQ(spoken("contact"), "not known");
}

TEST_F(DriveStripShown, namesRearContactsAndThoseOfBothSides)
{
    FlipperContacts rear = pressed();
    rear.flippers[indexOf(Flipper::RearLeft)][0] = {4.0, true};
    EXPECT_EQ(DriveText::contacts(rear), "L5 R6 rear L1");
    FlipperContacts both = pressed();
    both.sidesKnown = false;
    both.flippers[1] = both.flippers[0];
    EXPECT_EQ(DriveText::contacts(both), "5") << "no side is known";
    const int before = strip.minimumSizeHint().width();
    strip.setViewState({.contact = rear});
    EXPECT_GT(strip.minimumSizeHint().width(), before) << "the rear elements need room";
}

TEST_F(DriveStripShown, marksThatFeltGroundEnds)
{
    strip.setViewState({.speed = 0.214, .way = 0.4, .feltTo = 0.45});
    EXPECT_EQ(strip.text(DriveStrip::Speed), "+0.21 m/s");
    EXPECT_EQ(strip.text(DriveStrip::Way), "0.40 m");
    EXPECT_EQ(strip.text(DriveStrip::FeltTo), "+0.45 m");
    EXPECT_EQ(strip.caption(DriveStrip::FeltTo), "felt to");
    strip.setViewState({.way = 0.4, .feltTo = 0.2, .feltEnds = true});
    EXPECT_EQ(strip.caption(DriveStrip::FeltTo), "felt to !");
    strip.setViewState({.way = 0.4, .feltEnds = true});
    EXPECT_EQ(strip.text(DriveStrip::FeltTo), "none") << "known, but not felt";
    strip.setViewState({});
    EXPECT_EQ(strip.text(DriveStrip::FeltTo), "--") << "not known";
}

TEST_F(DriveStripShown, leavesOutLimitsAndThenWords)
{
    strip.setViewState(
        {.pitch = angle(26.0, AttitudeLevel::Amber), .roll = angle(2.0), .contact = known()});
    const auto says = [&](DriveDetail detail) {
        strip.resize(strip.widthFor(detail), strip.height());
        EXPECT_EQ(strip.detail(), detail);
        return painted();
    };
    const QString limits = QStringLiteral("! 25° ✘ 35°");
    EXPECT_EQ(says(DriveDetail::Limits).count(limits), 2);
    EXPECT_TRUE(says(DriveDetail::Words).contains("pitch ! STEEP"));
    EXPECT_FALSE(painted().contains(limits));
    EXPECT_TRUE(says(DriveDetail::Short).contains("pitch !"));
    EXPECT_TRUE(painted().contains(QStringLiteral("+26.0°")));
}

TEST_F(DriveStripShown, fitsItsTextsInEveryDetailAndSize)
{
    for (const int scale : {80, 100, 150, 200})
        for (const DriveDetail detail :
             {DriveDetail::Limits, DriveDetail::Words, DriveDetail::Short}) {
            look(ThemeName::Day, scale);
            strip.setViewState({.pitch = angle(-26.0, AttitudeLevel::Amber),
                                .roll = angle(-40.0, AttitudeLevel::Red),
                                .contact = pressed(),
                                .speed = -0.88,
                                .way = 12.34,
                                .feltTo = -1.25,
                                .feltEnds = true});
            QCoreApplication::processEvents();
            strip.resize(strip.widthFor(detail), strip.minimumSizeHint().height());
            EXPECT_EQ(shrunk(), QStringList()) << scale << ' ' << static_cast<int>(detail);
        }
}

TEST_F(DriveStripShown, radiansTakeNoMoreRoomThanDegrees)
{
    look(ThemeName::Day, 100);
    const int degrees = strip.minimumSizeHint().width();
    setUnits({.angle = AngleUnit::Radian});
    DriveStrip inRadians;
    inRadians.setViewState({.pitch = angle(-88.8, AttitudeLevel::Red), .roll = angle(2.0)});
    inRadians.resize(inRadians.minimumSizeHint());
    inRadians.setVisible(true);
    EXPECT_LE(inRadians.minimumSizeHint().width(), degrees + 12);
    QStringList painted;
    for (const DriveCell* cell : inRadians.findChildren<DriveCell*>()) {
        EXPECT_TRUE(cell->fits()) << cell->accessibleName().toStdString();
        for (const DriveCell::Line& line : cell->lines()) painted << line.text;
    }
    setUnits({});
    EXPECT_TRUE(painted.contains(QStringLiteral("−1.550"))) << painted.join('|').toStdString();
    EXPECT_TRUE(painted.contains(QStringLiteral("pitch rad ✘"))) << "the unit is named above";
    EXPECT_EQ(inRadians.text(DriveStrip::Pitch), QStringLiteral("−1.550 rad")) << "spoken in full";
}

TEST_F(DriveStripShown, aLongTextGetsASmallerFont)
{
    FlipperContacts rear = pressed();
    rear.flippers[indexOf(Flipper::RearLeft)][0] = {4.0, true};
    strip.setViewState({.contact = rear});
    strip.resize(strip.minimumSizeHint());
    EXPECT_EQ(shrunk(), QStringList{"contact"});
}

TEST_F(DriveStripShown, everyValueIsNamedAndSpoken)
{
    strip.setViewState({.pitch = angle(26.0, AttitudeLevel::Amber),
                        .roll = angle(2.0),
                        .feltTo = 0.2,
                        .feltEnds = true});
    EXPECT_EQ(strip.accessibleName(), "Driving");
    EXPECT_EQ(strip.findChildren<DriveCell*>().size(), DriveStrip::kCells);
    EXPECT_TRUE(spoken("pitch").startsWith(QStringLiteral("+26.0°; ! STEEP")))
        << spoken("pitch").toStdString();
    EXPECT_EQ(spoken("felt to"), "+0.20 m !");
    EXPECT_EQ(spoken("speed"), "--");
}

}  // namespace
}  // namespace terratact
