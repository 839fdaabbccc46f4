// Themes, letters, layouts, keys and names: that the console can be read and reached by everybody.
#include <gtest/gtest.h>
#include <qwt_plot_curve.h>
#include <qwt_symbol.h>

#include <QAbstractItemView>
#include <QAbstractSpinBox>
#include <QComboBox>
#include <QFocusEvent>
#include <QLabel>
#include <QMenu>
#include <QPushButton>
#include <QStackedWidget>
#include <QStyleOptionSpinBox>
#include <algorithm>
#include <array>
#include <cmath>
#include <set>

#include "app/bus_words.h"
#include "app/language.h"
#include "app/letters.h"
#include "app/main_window.h"
#include "app/settings_page.h"
#include "app/view_menu.h"
#include "core/atem/following.h"
#include "core/infer/estimate_words.h"
#include "core/infer/verdict.h"
#include "core/robot/force_sensor.h"
#include "core/sim/terrain_shapes.h"
#include "tests/support/absolem.h"
#include "tests/support/estimates.h"
#include "tests/support/gui.h"
#include "tests/support/sim_source.h"
#include "tests/support/temporary_directory.h"
#include "widgets/atem_panel.h"
#include "widgets/drive_pad.h"
#include "widgets/estimate_strip.h"
#include "widgets/event_list.h"
#include "widgets/held_button.h"
#include "widgets/look.h"
#include "widgets/navigation_rail.h"
#include "widgets/probe_card.h"
#include "widgets/robot_readout.h"
#include "widgets/status_header.h"
#include "widgets/terrain_profile_view.h"
#include "widgets/verdict_strip.h"
#include "widgets/words.h"

namespace terratact {
namespace {

using gui::eventually;
using Rgb = std::array<double, 3>;  // linear

constexpr std::array kThemes{ThemeName::Day, ThemeName::NightRed, ThemeName::HighContrast};

Rgb linear(const QColor& colour)
{
    const auto one = [](double c) {
        return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
    };
    return {one(colour.redF()), one(colour.greenF()), one(colour.blueF())};
}

/// WCAG 2.1, relative luminance and contrast ratio.
double contrast(const QColor& a, const QColor& b)
{
    const auto luminance = [](const QColor& colour) {
        const Rgb c = linear(colour);
        return 0.2126 * c[0] + 0.7152 * c[1] + 0.0722 * c[2];
    };
    const double x = luminance(a), y = luminance(b);
    return (std::max(x, y) + 0.05) / (std::min(x, y) + 0.05);
}

struct Pair {
    const char* name;
    QColor text, behind;
};

std::vector<Pair> textPairs(const Theme& t)
{
    std::vector<Pair> pairs{{"tip", t.text, t.tip},
                            {"header", t.headerText, t.header},
                            {"source", t.source, t.header},
                            {"source on a chosen page", t.source, t.chip.area},
                            {"chip off", t.chipOffText, t.chip.area},
                            {"prior only", t.doubt, t.priorZone},
                            {"muted on the zone", t.muted, t.priorZone},
                            {"contact", t.contact, t.card}};
    const std::pair<const char*, QColor> inks[]{{"text", t.text}, {"muted", t.muted},
                                                {"good", t.good}, {"doubt", t.doubt},
                                                {"bad", t.bad},   {"accent", t.accent}};
    for (const auto& [name, ink] : inks) {
        pairs.push_back({name, ink, t.card});
        pairs.push_back({name, ink, t.window});
    }
    const std::pair<const char*, Fill> fills[]{
        {"button", t.button},      {"off", t.off},
        {"primary", t.primary},    {"stop", t.stop},
        {"stopped", t.stopped},    {"decide", t.decide},
        {"caution", t.caution},    {"chip", t.chip},
        {"chip good", t.chipGood}, {"chip doubt", t.chipDoubt},
        {"chip bad", t.chipBad},   {"chip accent", t.chipAccent},
        {"banner", t.banner},      {"done", t.done}};
    for (const auto& [name, fill] : fills) pairs.push_back({name, fill.text, fill.area});
    pairs.push_back({"progress not done", t.done.text, t.card});
    return pairs;
}

TEST(Themes, everyTextCanBeRead)
{
    for (const ThemeName name : kThemes) {
        const double least = name == ThemeName::HighContrast ? 7.0 : 4.5;
        for (const Pair& pair : textPairs(themeOf(name)))
            EXPECT_GE(contrast(pair.text, pair.behind), least)
                << terratact::name(name) << ": " << pair.name;
    }
}

TEST(Themes, marksStandOutFromTheirGround)
{
    for (const ThemeName name : kThemes) {
        const Theme t = themeOf(name);
        for (const QColor& mark : {t.sampled, t.contact, t.arm, t.prior})
            EXPECT_GE(contrast(mark, t.card), 2.4) << terratact::name(name);
        EXPECT_GE(contrast(t.stop.area, t.header), 2.2) << terratact::name(name);
    }
}

/// CIELAB, D65.
Rgb lab(const Rgb& c)
{
    const auto f = [](double t) { return t > 0.008856 ? std::cbrt(t) : 7.787 * t + 16.0 / 116.0; };
    const double x = f((0.4124 * c[0] + 0.3576 * c[1] + 0.1805 * c[2]) / 0.9505);
    const double y = f(0.2126 * c[0] + 0.7152 * c[1] + 0.0722 * c[2]);
    const double z = f((0.0193 * c[0] + 0.1192 * c[1] + 0.9505 * c[2]) / 1.089);
    return {116.0 * y - 16.0, 500.0 * (x - y), 200.0 * (y - z)};
}

/// How eyes without one kind of cone see, from Machado, Oliveira and Fernandes, "A physiologically-based model for
/// simulation of color vision deficiency", IEEE TVCG 15 (2009), severity 1.
constexpr std::array<std::array<std::array<double, 3>, 3>, 3> kDeficiencies{
    {{{{0.152286, 1.052583, -0.204868},
       {0.114503, 0.786281, 0.099216},
       {-0.003882, -0.048116, 1.051998}}},
     {{{0.367322, 0.860646, -0.227968},
       {0.280085, 0.672501, 0.047413},
       {-0.011820, 0.042940, 0.968881}}},
     {{{1.255528, -0.076749, -0.178779},
       {-0.078411, 0.930809, 0.147602},
       {0.004733, 0.691367, 0.303900}}}}};

double leastDifference(const std::array<QColor, 4>& colours)
{
    double least = 1e9;
    for (const auto& matrix : kDeficiencies) {
        std::array<Rgb, 4> seen{};
        for (std::size_t i = 0; i < 4; ++i) {
            const Rgb c = linear(colours[i]);
            Rgb s{};
            for (std::size_t row = 0; row < 3; ++row)
                s[row] = std::clamp(matrix[row][0] * c[0] + matrix[row][1] * c[1]
                                        + matrix[row][2] * c[2],
                                    0.0, 1.0);
            seen[i] = lab(s);
        }
        for (std::size_t i = 0; i < 4; ++i)
            for (std::size_t j = 0; j < i; ++j)
                least = std::min(least, std::hypot(seen[i][0] - seen[j][0], seen[i][1] - seen[j][1],
                                                   seen[i][2] - seen[j][2]));
    }
    return least;
}

TEST(Themes, originsOfABinStayApartForEveryEye)
{
    // ΔE*ab of 2.3 is just noticeable.  Reds have no hues to tell apart: there the shapes alone must do.
    for (const ThemeName name : {ThemeName::Day, ThemeName::HighContrast}) {
        const Theme t = themeOf(name);
        const double least = leastDifference({t.sampled, t.contact, t.arm, t.prior});
        EXPECT_GT(least, 4.0 * 2.3) << terratact::name(name);
    }
    const TerrainProfileView view;
    std::set<int> shapes;
    int curves = 0;
    for (const QwtPlotItem* item : view.itemList(QwtPlotItem::Rtti_PlotCurve)) {
        ++curves;
        shapes.insert(static_cast<const QwtPlotCurve*>(item)->symbol()->style());
    }
    EXPECT_EQ(curves, 5);
    EXPECT_EQ(shapes.size(), 5U);
}

ModelLoader madeUp()
{
    return [] {
        return Result<LoadedModel>(
            LoadedModel{.estimate =
                            [](const EstimateRequest& request, const Watch&) {
                                TerrainEstimate e = stepEstimate();
                                e.settings = request.settings;
                                return e;
                            },
                        .name = "default.ttm",
                        .details = {}});
    };
}

struct Look : testing::Test {
    void SetUp() override { open(); }
    void TearDown() override
    {
        window.reset();
        applyLook(*qApp);
    }
    void open(const Preferences& preferences = {})
    {
        applyLook(*qApp, preferences.theme, preferences.fontScale);
        const QString path = QString::fromStdString(directory.file("console.ini"));
        MainWindow::Options options;
        options.robot = absolem();
        SimulatedRobot::Options simulation;
        simulation.startX = 2.1;
        options.source = std::make_unique<SimSource>(
            SimulatedRobot(options.robot, demoTerrain(), simulation), 20.0);
        options.model = madeUp();
        options.exploration.linkLostAfter = 5.0;
        options.preferences = std::make_unique<PreferenceStore>(loadPreferences(path), preferences);
        window = std::make_unique<MainWindow>(std::move(options));
        window->resize(1440, 900);
        gui::showActive(*window);
    }
    void explore()
    {
        ASSERT_TRUE(eventually([&] { return window->atemPanel()->requestButton()->isEnabled(); }));
        QTest::keyClick(window.get(), Qt::Key_A);
        ASSERT_TRUE(eventually([&] { return window->probeCard()->asks(); }, 60000));
        QTest::qWait(100);
    }
    void press(Qt::Key key) { QTest::keyClick(window.get(), key, Qt::ControlModifier); }
    void eachPage(const std::function<void()>& look)
    {
        for (int page = 0; page < window->rail()->pages(); ++page) {
            window->rail()->choose(page);
            QTest::qWait(80);
            look();
        }
        window->rail()->choose(0);
    }
    Preferences saved() const
    {
        return loadPreferences(QString::fromStdString(directory.file("console.ini"))).preferences;
    }
    TemporaryDirectory directory;
    std::unique_ptr<MainWindow> window;
};

/// The share of a picture that lights more than red.
double notRed(const QImage& image)
{
    int count = 0;
    for (int y = 0; y < image.height(); ++y)
        for (int x = 0; x < image.width(); ++x) {
            const QColor c = image.pixelColor(x, y);
            if (std::max(c.green(), c.blue()) > 0.52 * c.red() + 6) ++count;
        }
    return static_cast<double>(count) / (image.width() * image.height());
}

TEST_F(Look, inTheNightThemeEveryPixelIsRed)
{
    explore();
    EXPECT_GT(notRed(gui::painted(*window)), 0.5) << "by day";
    press(Qt::Key_5);
    eachPage([&] { EXPECT_EQ(notRed(gui::painted(*window)), 0.0) << window->rail()->chosen(); });
    QTest::mousePress(window->header()->stopButton(), Qt::LeftButton);
    ASSERT_TRUE(eventually([&] { return window->atemPanel()->releaseButton()->isVisible(); }));
    EXPECT_EQ(notRed(gui::painted(*window)), 0.0) << "stopped";
    press(Qt::Key_4);
    QTest::qWait(80);
    EXPECT_GT(notRed(gui::painted(*window)), 0.5) << "the theme changes back while it runs";
}

TEST_F(Look, nothingIsCutInLargeLetters)
{
    explore();
    const std::pair<int, QSize> cases[]{
        {80, {1440, 900}}, {120, {1440, 900}}, {150, {1440, 900}}, {200, {2560, 1440}}};
    for (const auto& [scale, size] : cases) {
        window->setRoom(size);
        window->preferences().change([scale = scale](Preferences& p) { p.fontScale = scale; });
        for (const Qt::Key layout : {Qt::Key_1, Qt::Key_3, Qt::Key_2}) {
            press(layout);
            window->resize(size);
            QTest::qWait(100);
            EXPECT_EQ(window->size(), size) << "the layout needs more than this";
            (void)eventually([&] { return gui::cutText(*window).empty(); }, 2000);  // laid out
            EXPECT_EQ(gui::cutText(*window), std::vector<std::string>())
                << scale << " % " << layout;
        }
    }
}

TEST_F(Look, nothingIsCutInAnyLanguage)
{
    for (const char* language : {"en", "cs", "de"}) {
        window.reset();
        if (installLanguage(*qApp, language) != QLatin1String(language))
            GTEST_SKIP() << "built without translations";
        open();
        explore();
        for (const QSize size : {QSize(1280, 720), QSize(1440, 900), window->minimumSize()}) {
            window->resize(size);
            QTest::qWait(100);
            eachPage([&] {
                (void)eventually([&] { return gui::cutText(*window).empty(); }, 2000);  // laid out
                EXPECT_EQ(gui::cutText(*window), std::vector<std::string>())
                    << language << ", width " << size.width() << ", page "
                    << window->rail()->chosen();
            });
        }
        EXPECT_EQ(window->keys().html().contains("drive back"), language == std::string_view("en"));
    }
    installLanguage(*qApp, "en");
}

/// Every value of an enumeration from 0 on for which describe() has words.
template <class Enum>
QStringList allOf(int count)
{
    QStringList sentences;
    for (int i = 0; i < count; ++i)
        sentences << QString::fromStdString(describe(static_cast<Enum>(i)));
    return sentences;
}

TEST(Languages, whatTheCoreSaysIsTranslatedAndKeepsItsNumbers)
{
    constexpr const char* kTrouble =
        "/home/no 2/mine.ttm: cannot be opened: No such file or directory";
    TerrainEstimate estimate = stepEstimate();
    for (int i = 0; i < 400; ++i) {
        estimate.draws.push_back(estimate.height);
        if (i % 2 == 0) estimate.draws.back()[9] -= 0.3;
    }
    QStringList said = allOf<AtemPhase>(10) + allOf<AtemFailure>(12) + allOf<DisarmCause>(11)
                     + allOf<GateRefusal>(20) + allOf<Doubt>(5) + allOf<RobotActivity>(6)
                     + allOf<Refusal>(9) + QStringList{"yes", "no", "none", "not measured"};
    for (int i = 0; i < 10; ++i)
        said << QString::fromStdString(describeFollowed(static_cast<AtemPhase>(i)));
    for (const ElementState state :
         {ElementState::Saturated, ElementState::Open, ElementState::Short})
        said << QString::fromStdString(describe(state));
    for (const double limit : {0.1, 0.9})  // open, and all but certain
        for (const std::string& sentence : hiddenByBands(estimate, limit))
            said << QString::fromStdString(sentence);
    for (const Outlook outlook : {Outlook::Clear, Outlook::Blocked, Outlook::CannotTell})
        said << words::text(name(outlook));
    for (const char* language : {"cs", "de"}) {
        if (installLanguage(*qApp, language) != QLatin1String(language))
            GTEST_SKIP() << "built without translations";
        for (const BusState state :
             {BusState::Up, BusState::Stalled, BusState::ErrorPassive, BusState::BusOff,
              BusState::Down, BusState::Absent, BusState::Ended}) {
            const QString english = QString::fromStdString(describe(state, "can0"));
            const QString translated = busWords(state, "can0");
            EXPECT_NE(translated, english) << language;
            EXPECT_TRUE(translated.startsWith("can0 ")) << translated.toStdString();
            const auto command = [](const QString& text) { return text.section(" (", -1); };
            EXPECT_TRUE(!english.endsWith(')') || command(translated) == command(english))
                << translated.toStdString();
        }
        for (const QString& english : said)
            EXPECT_NE(words::sentence(english.toStdString()), english) << language;
        const QString roll =
            words::sentence("roll -5.2°: the ground is not the same left and right");
        EXPECT_TRUE(roll.contains("-5.2°") && !roll.contains("ground")) << roll.toStdString();
        EXPECT_EQ(words::sentence("nobody knows 3 of these"), "nobody knows 3 of these");
        const QStringList trouble = words::sentence(kTrouble).split(": ");
        ASSERT_EQ(trouble.size(), 3) << language;
        EXPECT_EQ(trouble[0], "/home/no 2/mine.ttm");
        EXPECT_NE(trouble[1], "cannot be opened");
        EXPECT_NE(trouble[2], "No such file or directory");
    }
    EXPECT_EQ(installLanguage(*qApp, "tlh"), "en");
    EXPECT_EQ(words::sentence("ready"), "ready");
    EXPECT_EQ(words::sentence(kTrouble), kTrouble);
}

TEST(Letters, areTheLargestThatFit)
{
    const auto needs = [](int percent) { return QSize(10 * percent, 5 * percent); };
    EXPECT_EQ(lettersThatFit(100, {2000, 2000}, needs), 100) << "never larger than wanted";
    EXPECT_EQ(lettersThatFit(200, {2000, 1000}, needs), 200) << "just so";
    EXPECT_EQ(lettersThatFit(200, {1999, 2000}, needs), 190) << "too wide";
    EXPECT_EQ(lettersThatFit(200, {2000, 701}, needs), 140) << "too high";
    EXPECT_EQ(lettersThatFit(155, {1460, 2000}, needs), 145) << "steps are from the wanted ones";
    EXPECT_EQ(lettersThatFit(200, {100, 100}, needs), kSmallestFont) << "smaller there are none";
}

TEST_F(Look, lettersThatDoNotFitTheScreenAreSaidAndKeptForALargerOne)
{
    window->setRoom({1200, 680});
    window->preferences().change([](Preferences& p) { p.fontScale = 200; });
    const int fits = lookInForce().fontScale;
    EXPECT_LT(fits, 200);
    EXPECT_LE(window->minimumWidth(), 1200);
    EXPECT_LE(window->minimumHeight(), 680);
    const QString note = QStringLiteral("200 % wanted, %1 % fits this screen").arg(fits);
    EXPECT_EQ(lettersNote(200), note);
    window->rail()->choose(window->rail()->pageOf(Qt::Key_F7));
    EXPECT_TRUE(eventually([&] { return window->settings()->lettersNote()->isVisible(); }));
    EXPECT_EQ(window->settings()->lettersNote()->text(), note);
    ViewMenu menu(window->preferences(), "at once");
    menu.popup(window->pos());
    EXPECT_TRUE(menu.actions().last()->isVisible());
    EXPECT_EQ(menu.actions().last()->text(), note);
    menu.hide();

    window->setRoom({1920, 1080});
    EXPECT_EQ(lookInForce().fontScale, 200);
    EXPECT_EQ(window->preferences().current().fontScale, 200);
    EXPECT_TRUE(eventually([&] { return !window->settings()->lettersNote()->isVisible(); }));
    EXPECT_EQ(lettersNote(200), QString());

    window->setRoom({1200, 680});
    press(Qt::Key_Minus);
    EXPECT_EQ(lookInForce().fontScale, fits - 10) << "smaller than what is seen, not than wanted";
}

TEST_F(Look, lettersGrowAndShrinkWithinTheirLimits)
{
    const int before = window->header()->stopButton()->height();
    for (int i = 0; i < 5; ++i) press(Qt::Key_Plus);
    EXPECT_EQ(window->preferences().current().fontScale, 150);
    EXPECT_GT(window->header()->stopButton()->height(), before);
    for (int i = 0; i < 20; ++i) press(Qt::Key_Minus);
    EXPECT_EQ(window->preferences().current().fontScale, kSmallestFont);
    press(Qt::Key_0);
    EXPECT_EQ(window->preferences().current().fontScale, 100);
}

/// Whatever an operator can point at or tab to.
QList<QWidget*> controls(const MainWindow& window)
{
    QList<QWidget*> found;
    for (QWidget* widget : window.findChildren<QWidget*>()) {
        // What Qt put into one of our own widgets speaks through it.
        const bool inner = widget->objectName().startsWith("qt_");
        const bool control =
            qobject_cast<QAbstractButton*>(widget) || (widget->focusPolicy() & Qt::TabFocus);
        if (control && !inner && widget->isVisible()) found << widget;
    }
    return found;
}

/// Parts of a control that are pressed on their own: the arrows of a spin box, the entries of its menu or list; [px].
QList<QSize> partsOf(const QWidget& control)
{
    QList<QSize> parts;
    if (const auto* box = qobject_cast<const QAbstractSpinBox*>(&control)) {
        QStyleOptionSpinBox option;
        option.initFrom(box);
        option.subControls = QStyle::SC_All;
        option.buttonSymbols = box->buttonSymbols();
        option.frame = box->hasFrame();
        const auto rect = [&](QStyle::SubControl part) {
            return box->style()->subControlRect(QStyle::CC_SpinBox, &option, part, box);
        };
        const QRect up = rect(QStyle::SC_SpinBoxUp), down = rect(QStyle::SC_SpinBoxDown);
        EXPECT_FALSE(up.intersects(down));
        EXPECT_FALSE(rect(QStyle::SC_SpinBoxEditField).intersects(down));
        if (box->buttonSymbols() != QAbstractSpinBox::NoButtons) parts << up.size() << down.size();
    }
    const auto* button = qobject_cast<const QPushButton*>(&control);
    if (QMenu* menu = button ? button->menu() : nullptr; menu) {
        menu->ensurePolished();
        for (QAction* action : menu->actions())
            if (!action->isSeparator()) parts << menu->actionGeometry(action).size();
    }
    if (const auto* combo = qobject_cast<const QComboBox*>(&control))
        for (int row = 0; row < combo->count(); ++row)
            parts << QSize(combo->width(), combo->view()->sizeHintForRow(row));
    return parts;
}

TEST_F(Look, everyControlHasANameAndASize)
{
    int parts = 0;
    explore();
    eachPage([&] {
        const auto all = controls(*window);
        EXPECT_GE(all.size(), 4);
        for (const QWidget* control : all) {
            const auto* button = qobject_cast<const QAbstractButton*>(control);
            const std::string what =
                std::string(control->metaObject()->className()) + " "
                + (button ? button->text() : control->objectName()).toStdString();
            EXPECT_FALSE(control->accessibleName().isEmpty()
                         && (!button || button->text().isEmpty()))
                << what;
            EXPECT_GE(control->height(), 32) << what;
            for (const QSize part : partsOf(*control)) {
                ++parts;
                EXPECT_TRUE(part.width() >= 32 && part.height() >= 32)
                    << what << ": a part of " << part.width() << " × " << part.height();
            }
            EXPECT_FALSE(button && button->toolTip().isEmpty())
                << what << " says neither what it does nor why not";
        }
    });
    EXPECT_GE(parts, 30);
}

TEST_F(Look, aButtonThatCannotBePressedSaysWhyNot)
{
    gui::TipsOfButtons tips;
    const auto lookEverywhere = [&] { eachPage([&] { tips.look(*window); }); };
    lookEverywhere();
    for (const double limit : {VerdictStrip::kLeastLimit, VerdictStrip::kGreatestLimit}) {
        window->preferences().change([limit](Preferences& p) { p.obstacleLimit = limit; });
        tips.look(*window);
    }
    window->preferences().change([](Preferences& p) { p.model = "/nowhere/none.ttm"; });
    explore();
    lookEverywhere();
    window->exploration().stop();  // which is an alarm, too
    ASSERT_TRUE(eventually([&] { return window->atemPanel()->releaseButton()->isVisible(); }));
    lookEverywhere();
    EXPECT_EQ(tips.silent(), std::vector<std::string>());
    for (const char* name : {"Lower the limit", "Raise the limit", "Acknowledge", "Acknowledge all",
                             "The shipped one: Model", "Explore the terrain (A)"})
        EXPECT_TRUE(tips.compared().contains(name)) << name;
}

TEST_F(Look, TabReachesEverythingAndComesBack)
{
    explore();
    eachPage([&] {
        window->setFocus();
        std::set<QWidget*> reached;
        for (int i = 0; i < 300; ++i) {
            QWidget* at = QApplication::focusWidget();
            ASSERT_NE(at, nullptr);
            QTest::keyClick(at, Qt::Key_Tab);
            QWidget* next = QApplication::focusWidget();
            if (!next || reached.contains(next)) break;
            reached.insert(next);
        }
        for (QWidget* control : controls(*window)) {
            const bool reachable = control->isEnabled() && (control->focusPolicy() & Qt::TabFocus);
            EXPECT_TRUE(!reachable || reached.contains(control))
                << control->metaObject()->className() << " "
                << control->accessibleName().toStdString();
        }
    });
}

TEST_F(Look, theSheetTellsOfEveryKeyAndEveryKeyActs)
{
    const QString sheet = window->keys().html();
    std::set<int> seen;
    for (const KeyTable::Entry& entry : window->keys().entries()) {
        EXPECT_FALSE(entry.meaning.isEmpty());
        EXPECT_TRUE(sheet.contains(entry.meaning.toHtmlEscaped()));
        for (const QKeyCombination key : entry.keys) {
            EXPECT_TRUE(seen.insert(key.toCombined()).second) << "a key with two meanings";
            const QKeyEvent event(QEvent::KeyPress, key.key(), key.keyboardModifiers());
            EXPECT_EQ(window->keys().entryOf(event), &entry);
            EXPECT_TRUE(sheet.contains(
                QKeySequence(key).toString(QKeySequence::NativeText).toHtmlEscaped()));
        }
    }
    KeyTable twice;
    twice.add({{Qt::Key_A}, "one", {}});
    EXPECT_THROW(twice.add({{Qt::Key_B, Qt::Key_A}, "two", {}}), std::logic_error);
    const QKeyEvent withAlt(QEvent::KeyPress, Qt::Key_A, Qt::AltModifier);
    EXPECT_EQ(twice.entryOf(withAlt), nullptr);
}

TEST_F(Look, everyLayoutShowsStopStateAndWhatAsks)
{
    for (const Qt::Key layout : {Qt::Key_1, Qt::Key_2, Qt::Key_3}) {
        press(layout);
        QTest::qWait(60);
        EXPECT_TRUE(window->header()->stopButton()->isVisible());
        EXPECT_TRUE(window->atemPanel()->isVisible());
        EXPECT_TRUE(window->terrain()->isVisible());
        EXPECT_EQ(window->drivePad()->isVisible(), layout != Qt::Key_3);
        EXPECT_EQ(window->events()->isVisible(), layout != Qt::Key_1);
        EXPECT_EQ(window->probeCard()->isVisible(), layout == Qt::Key_2);
    }
    explore();
    EXPECT_TRUE(window->probeCard()->isVisible()) << "it asks in the review layout";
    press(Qt::Key_Home);
    EXPECT_EQ(window->preferences().current().layout, Layout::Probe);
}

TEST_F(Look, whatWasChosenIsSavedAndWhatTheCommandLineSaidIsNot)
{
    Preferences fromCommandLine;
    fromCommandLine.theme = ThemeName::HighContrast;
    window.reset();
    open(fromCommandLine);
    press(Qt::Key_3);
    EXPECT_EQ(window->preferences().current().theme, ThemeName::HighContrast);
    EXPECT_EQ(saved().theme, ThemeName::Day);
    EXPECT_EQ(saved().layout, Layout::Review);
    window->close();
    EXPECT_FALSE(saved().window.isEmpty());
}

TEST_F(Look, aTroubleWithThePreferencesIsAnEvent)
{
    window.reset();
    directory.write("console.ini", "[General]\nschema=1\ntheme=purple\n");
    open();
    EXPECT_TRUE(eventually([&] {
        return window->events()->count() > 0
            && !window->events()->findItems("purple", Qt::MatchContains).isEmpty();
    }));
}

TEST_F(Look, aTroubleWithThePreferencesIsInTheLanguageOfWhenItIsSaid)
{
    directory.write("console.ini", "[General]\nschema=1\nlanguage=cs\ntheme=purple\n");
    LoadedPreferences loaded =
        loadPreferences(QString::fromStdString(directory.file("console.ini")));
    loaded.troubles.push_back(robotNotUsed(Error{"mine.toml: is empty"}));
    const PreferenceStore store(loaded, loaded.preferences);
    const QStringList english = store.troubles();
    if (installLanguage(*qApp, store.current().language) != "cs")
        GTEST_SKIP() << "built without translations";
    const QStringList czech = store.troubles();
    installLanguage(*qApp, "en");
    ASSERT_EQ(czech.size(), 2);
    EXPECT_TRUE(czech[0].contains("purple") && czech[0] != english[0]);
    EXPECT_TRUE(czech[1].contains("mine.toml: ") && !czech[1].contains("is empty"));
}

TEST_F(Look, safeModeIsSaidOnEveryPageAndCutsNothing)
{
    window->hide();
    window->saySafeMode();
    gui::showActive(*window);
    for (const QSize size : {QSize(1200, 680), QSize(1440, 900)}) {
        window->setRoom(size);
        window->resize(size);
        eachPage([&] {
            const QStringList texts = gui::readableTexts(*window);
            EXPECT_TRUE(std::ranges::any_of(texts, [](const QString& text) {
                return text.contains("SAFE MODE") && text.contains("without --safe-mode");
            }));
            EXPECT_EQ(window->size(), size);
            (void)eventually([&] { return gui::cutText(*window).empty(); }, 2000);  // laid out
            EXPECT_EQ(gui::overlaps(*window), std::vector<std::string>());
            EXPECT_EQ(gui::cutText(*window), std::vector<std::string>());
        });
    }
}

TEST(TerrainPageAlone, saysNoTelemetryYoungerThanItMayBe)
{
    TerrainPage page(absolem());
    gui::showActive(page);
    const Measurement m;
    const auto says = [&](double age, bool due, double numbersFor) {
        TerrainSight sight;
        sight.measurement = &m;
        sight.age = age;
        sight.numbersDue = due;
        sight.numbersFor = numbersFor;
        page.setSight(sight);
        for (const QLabel* label : page.findChildren<QLabel*>())
            if (label->accessibleName() == "Age of the telemetry") return label->text();
        return QString();
    };
    EXPECT_EQ(says(0.046, true, 0.0), "46 ms old") << "it stands";
    EXPECT_EQ(says(0.046, true, 0.24), "< 0.3 s old") << "when it is shown anew";
    EXPECT_EQ(says(0.149, false, 0.24), "< 0.3 s old") << "these are still those numbers";
    EXPECT_EQ(says(0.149, true, 0.24), "< 0.4 s old");
    EXPECT_EQ(says(0.16, false, 0.24), "0.2 s old") << "at once";
    EXPECT_EQ(page.readout()->text(RobotReadout::Pitch), "--");
    EXPECT_EQ(says(1.27, false, 0.24), "1.3 s old") << "and it grows";
}

TEST(TerrainPageAlone, saysThatFlippersMoveOnlyWhileTheyDo)
{
    TerrainPage page(absolem());
    gui::showActive(page);
    const Measurement m;
    const TerrainEstimate preview = stepEstimate();
    const auto says = [&](AtemPhase phase) {
        TerrainSight sight;
        sight.measurement = &m;
        sight.live = &preview;
        sight.state.phase = phase;
        page.setSight(sight);
        return page.verdict()->reason() + "\n" + page.terrain()->accessibleDescription() + "\n"
             + page.strip()->headline();
    };
    const QString moving = says(AtemPhase::Pressing), computing = says(AtemPhase::Estimating);
    EXPECT_EQ(moving.count("flippers still move"), 2) << moving.toStdString();
    EXPECT_TRUE(moving.contains("LIVE preview"));
    EXPECT_EQ(computing.count("flippers still move"), 0) << computing.toStdString();
    EXPECT_EQ(computing.count("estimate is being computed"), 2) << computing.toStdString();
    EXPECT_FALSE(computing.contains("LIVE"));
}

}  // namespace
}  // namespace terratact
