// Pictures of an estimate on every page and in every theme, of model training and of reviews; see screens_test.cpp.
#include <QComboBox>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QProgressBar>
#include <QPushButton>
#include <QScrollArea>
#include <QScrollBar>
#include <QTableWidget>

#include "app/console/pages/settings_page.h"
#include "app/console/pages/training_page.h"
#include "app/console/profile_menu.h"
#include "app/display/format.h"
#include "app/display/translated.h"
#include "app/review/export/review_export_dialog.h"
#include "app/review/review_events_page.h"
#include "app/review/review_view_state.h"
#include "app/review/scenes_page.h"
#include "app/review/what_if_page.h"
#include "app/runtime/resources.h"
#include "app/shell/about.h"
#include "app/shell/remote_stop.h"
#include "app/shell/text_sheet.h"
#include "app/shell/view_menu.h"
#include "core/learn/data/scene_file.h"
#include "core/log/session_reader.h"
#include "tests/app/console/screens/screens.h"
#include "tests/support/gui.h"
#include "tests/support/toy_model.h"
#include "widgets/base/held_button.h"
#include "widgets/base/navigation_rail.h"
#include "widgets/base/theme.h"
#include "widgets/control/arming_control.h"
#include "widgets/control/atem_panel.h"
#include "widgets/control/drive_pad.h"
#include "widgets/control/status_header.h"
#include "widgets/signals/event_list.h"
#include "widgets/signals/force_bars.h"

namespace terratact {

using gui::eventually;

TEST_F(Screens, result)
{
    inEveryLanguage([&] {
        open({});
        ASSERT_NO_FATAL_FAILURE(explore());
        press(Qt::Key_N);
        ASSERT_TRUE(reaches(AtemPhase::Presenting));
        const struct {
            Qt::Key key;
            std::string_view name;
            QString says;
        } kPages[]{{Qt::Key_F3, "page_numbers", QStringLiteral("0.6")},
                   {Qt::Key_F4, "page_alarms", StatusHeader::tr("no alarms")},
                   {Qt::Key_F5, "page_signals", QStringLiteral("Attitude")},
                   {Qt::Key_F6, "page_training", TrainingPage::tr("Idle")},
                   {Qt::Key_F7, "page_settings", SettingsPage::tr("Method")},
                   {Qt::Key_F8, "page_diagnostics", QStringLiteral("OpenBLAS")}};
        for (const auto& page : kPages) {
            press(page.key);
            EXPECT_EQ(console->rail()->chosen(), console->rail()->pageOf(page.key));
            picture(page.name, {page.says});
        }
        press(Qt::Key_F2);

        const QString stands = translated(describe(AtemPhase::Presenting));
        press(Qt::Key_1, Qt::ControlModifier);
        picture("layout_drive", {stands});
        EXPECT_EQ(console->preferences().current().layout, Layout::Drive);
        press(Qt::Key_3, Qt::ControlModifier);
        picture("layout_review", {stands});
        EXPECT_EQ(console->preferences().current().layout, Layout::Review);
        press(Qt::Key_2, Qt::ControlModifier);
        press(Qt::Key_F1);
        QWidget* sheet = nullptr;
        for (QWidget* other : QApplication::topLevelWidgets())
            if (other != &window() && other->isVisible()) sheet = other;
        ASSERT_TRUE(sheet);
        EXPECT_EQ(sheet->size().expandedTo(sheet->sizeHint()), sheet->size()) << "keys are cut";
        EXPECT_EQ(sheet->size().boundedTo(window().size()), sheet->size());
        pictureWith(*sheet, "keys", {stands});
        sheet->close();

        console->setRoom({1200, 680});
        console->resize(1200, 680);
        picture("smallest", {stands});
        EXPECT_EQ(console->size(), QSize(1200, 680));
        press(Qt::Key_F7);
        QTest::qWait(60);  // painting the page fills the card
        auto* area = console->settings()->findChild<QScrollArea*>();
        area->verticalScrollBar()->setValue(area->verticalScrollBar()->maximum());
        picture("settings_down_to_the_model_card", {QStringLiteral("robots/absolem.toml")});
        press(Qt::Key_F2);
        console->setRoom({1440, 900});
        console->resize(1440, 900);
        console->preferences().change([](Preferences& p) { p.fontScale = 200; });
        picture("letters_200_percent", {stands});
        EXPECT_GE(lookInForce().fontScale, 180) << "they are as large as the words let them be";
        press(Qt::Key_F9);
        EXPECT_TRUE(eventually([&] { return console->forces()->isVisible(); }));
        picture("letters_200_percent_page_robot", {QStringLiteral("N")});
        const QRect events(console->events()->mapTo(&window(), QPoint()),
                           console->events()->size());
        EXPECT_TRUE(window().rect().contains(events)) << "no need to scroll to the last minutes";
        press(Qt::Key_F2);
        console->preferences().change([](Preferences& p) { p.fontScale = 100; });

        const auto way = [&] {
            const Estimation& estimation = console->exploration().estimation();
            const SeenStrip seen = estimation.remembered();
            return estimation.estimate() || seen.isEmpty() ? 0.0 : seen.side[0].front().way;
        };
        ASSERT_NO_FATAL_FAILURE(explore());
        robot->stage({.explores = true});
        press(Qt::Key_N);
        ASSERT_TRUE(eventually([&] { return console->drivePad()->backButton()->isEnabled(); }));
        QTest::keyPress(&window(), Qt::Key_S);
        QTest::qWait(100);  // the robot ends the exploration slowly; the key is counted
        robot->stage({});
        (void)eventually([&] { return way() > 0.2; });
        QTest::keyRelease(&window(), Qt::Key_S);
        const QString moved = Exploration::tr("The robot has moved: explore again (A)");
        picture("remembered", {moved});
        EXPECT_GT(way(), 0.2) << console->exploration()
                                     .estimation()
                                     .whyNothingRemembered()
                                     .value_or(Message())
                                     .english();
        console->setRoom({1200, 680});
        console->resize(1200, 680);
        for (const auto& [theme, name] :
             {std::pair(ThemeName::NightRed, "remembered_by_night"),
              std::pair(ThemeName::HighContrast, "remembered_in_high_contrast")}) {
            console->preferences().change([theme = theme](Preferences& p) { p.theme = theme; });
            picture(name, {moved});
        }
        press(Qt::Key_F1, Qt::ControlModifier);
        auto* about = console->findChild<TextSheet*>(QStringLiteral("about"));
        ASSERT_TRUE(about && about->isVisible());
        pictureWith(*about, "about", {QCoreApplication::translate("About", kQwtCredit)});
        about->close();
    });
}

TEST_F(Screens, training)
{
    constexpr int kPatience = 180000;  // [ms] for steps that take seconds on an idle machine
    const TemporaryDirectory files;
    ASSERT_TRUE(writeScenes(files.file("learn.csv"), someScenes(4, 1)));
    ASSERT_TRUE(writeScenes(files.file("test.csv"), someScenes(2, 7)));
    inEveryLanguage([&] {
        const TemporaryDirectory models;
        qputenv("XDG_DATA_HOME", QByteArray::fromStdString(models.file("share")));
        open({});
        qunsetenv("XDG_DATA_HOME");
        TrainingPage& page = *console->training();
        press(Qt::Key_F6);
        page.scenesField()->setText(QString::fromStdString(files.file("learn.csv")));
        page.startButton()->click();
        ASSERT_TRUE(eventually(
            [&] { return page.bins()->item(0, 1)->text() != TrainingPage::tr("waiting"); },
            kPatience));
        picture("training_running", {TrainingPage::tr("training: %1 %"),
                                     TrainingPage::tr("Training on %1; driving is not affected")});
        ASSERT_TRUE(eventually([&] { return !page.cancelButton()->isEnabled(); }, kPatience));
        page.testField()->setText(QString::fromStdString(files.file("test.csv")));
        ASSERT_TRUE(page.compareButton()->isEnabled()) << page.status()->text().toStdString();
        page.compareButton()->click();
        ASSERT_TRUE(eventually([&] { return page.adoptButton()->isEnabled(); }, kPatience))
            << page.status()->text().toStdString();
        picture("training_compared", {TrainingPage::tr("Idle · done (log-likelihood %1)"),
                                      TrainingPage::tr("Compared on %1 scenes")});
    });
}

TEST_F(Screens, menus)
{
    inEveryLanguage([&] {
        open({});
        ASSERT_TRUE(
            eventually([&] { return console->header()->arming()->armButton()->isEnabled(); }));
        const auto isMeasured = [&] {  // the measured costs appear once the model is loaded
            const QMenu* menu = console->header()->qualityButton()->menu();
            return menu && menu->actions().first()->text().contains(QStringLiteral(" ms"));
        };
        ASSERT_TRUE(eventually(isMeasured));
        pictureOfMenu(
            *console->header()->qualityButton(), "menu_quality",
            {QCoreApplication::translate(
                "PresetWords", "%1: %2 ms, exact quantiles by a formula, mean error %3 mm")});
        pictureOfMenu(*console->viewButton(), "menu_terrain",
                      {ProfileMenu::tr("Some of the draws as thin lines (D)"),
                       ProfileMenu::tr("A second method beside it"), QStringLiteral("joint")});
        pictureOfMenu(*console->atemPanel()->needsButton(), "menu_needs",
                      {AtemPanel::tr("exploring"), AtemPanel::tr("releasing STOP")});
        auto* help = console->rail()->findChild<QPushButton*>(QStringLiteral("help"));
        QPushButton* view = nullptr;
        for (QPushButton* button : console->rail()->findChildren<QPushButton*>())
            if (button->menu() && button != help) view = button;
        ASSERT_TRUE(view && help);
        pictureOfMenu(*help, "menu_help",
                      {ConsoleWindow::tr("Keys"), ConsoleWindow::tr("About Terratact"),
                       ConsoleWindow::tr("Recorded demonstration")});
        pictureOfMenu(*view, "menu_view",
                      {ViewMenu::tr("layout: drive"), ViewMenu::tr("colours: night, red"),
                       ViewMenu::tr("larger text"), ViewMenu::tr("language: %1")});
    });
}

TEST_F(Screens, review)
{
    constexpr int kCanFrames = 3;  // index in the export list
    inEveryLanguage([&] {
        ASSERT_NO_FATAL_FAILURE(openReview());
        review->goTo(66.0);
        ASSERT_TRUE(eventually([&] { return review->surveyed(); }));
        ASSERT_TRUE(review->moment().model);
        const QString recordedModel = format::text(review->moment().model->details);
        picture("review",
                {ReviewWindow::tr("closed and sealed"), ReviewWindow::tr("no command can be sent"),
                 ReviewViewState::tr("A review commands no robot")});
        press(Qt::Key_F4);
        picture("review_events", {QStringLiteral("demo.tts")});
        for (const std::string& text : gui::textsOf(*review->events()))
            unsay(QString::fromStdString(text));
        press(Qt::Key_F6);
        picture("what_if", {WhatIfPage::tr("Estimate %1 of scene %2 at %3 s, by %4 with the model "
                                           "%5")});
        WhatIfPage& whatIf = *review->whatIf();
        whatIf.method()->setCurrentText(format::text(name(Method::Joint)));
        press(Qt::Key_E);
        ASSERT_TRUE(eventually([&] { return whatIf.answer().value().has_value(); }, 60000));
        picture("what_if_by_another_method",
                {WhatIfPage::tr("Differs from the recorded estimate by %1 at most, at bin %2.")});
        for (int i = 0; i < 10; ++i) press(Qt::Key_Plus, Qt::ControlModifier);
        press(Qt::Key_F5);
        picture("review_letters_200_percent_page_robot", {QStringLiteral("N")});
        const auto right = [](const QWidget& card, const QWidget& in) {
            return card.mapTo(&in, QPoint(card.width(), 0)).x();
        };
        EXPECT_LE(right(*review->terrainPage()->events(), *review), review->width());
        press(Qt::Key_0, Qt::ControlModifier);
        press(Qt::Key_F2);
        const TemporaryDirectory files;
        press(Qt::Key_E, Qt::ControlModifier);
        auto* exporting = review->findChild<ReviewExportDialog*>();
        ASSERT_TRUE(exporting && eventually([&] { return exporting->isVisible(); }));
        exporting->pathEdit()->setText(QString::fromStdString(files.file("demo.png")));
        pictureWith(*exporting, "export",
                    {ReviewExportDialog::tr("What"), ReviewExportDialog::tr("Export")});
        exporting->what()->setCurrentIndex(kCanFrames);
        exporting->exportButton()->click();
        ASSERT_TRUE(eventually([&] { return !exporting->writes(); }, 60000));
        pictureWith(
            *exporting, "export_written",
            {ReviewExportDialog::tr("Written: %1"), ReviewExportDialog::tr("Replace the file")});
        exporting->close();
        press(Qt::Key_F12);
        QWidget* banner = nullptr;
        for (QLabel* label : review->findChildren<QLabel*>())
            if (label->isVisible() && label->objectName() == QLatin1String("banner"))
                banner = label;
        ASSERT_TRUE(banner);
        pictureWith(*banner, "review_has_no_stop",
                    {ConsoleWindow::tr("STOP HAS NO EFFECT HERE: this window has no robot. Use the "
                                       "console's own window")});
        qputenv(kStopLineVariable, "nobody");
        openReview();
        qunsetenv(kStopLineVariable);
        EXPECT_TRUE(review->header()->stopButton()->isVisible());
        picture("review_with_the_stop_of_its_console", {StatusHeader::tr("STOP (F12)")});
        unsay(recordedModel);
    });
}

TEST_F(Screens, scenes)
{
    inEveryLanguage([&] {
        ASSERT_NO_FATAL_FAILURE(openScenes());
        ASSERT_TRUE(eventually([&] { return scenes->estimate().has_value(); }, 60000));
        press(Qt::Key_Period);
        ASSERT_TRUE(eventually([&] { return scenes->estimate().has_value(); }, 60000));
        const QString state = ScenesWindow::tr("SCENE %1 of %2 in %3 · drive %4 at %5 s · "
                                               "estimated now, not recorded · %6");
        picture("scenes", {state, ScenesWindow::tr("SCENES OF A FILE")});
        press(Qt::Key_F3);
        picture("scenes_list", {state, ScenesPage::tr("Scenes of the file")});
        press(Qt::Key_F2);
        press(Qt::Key_F1);
        QWidget* sheet = nullptr;
        for (QWidget* other : QApplication::topLevelWidgets())
            if (other != &window() && other->isVisible()) sheet = other;
        ASSERT_TRUE(sheet);
        pictureWith(*sheet, "scenes_keys", {state, ScenesWindow::tr("next scene")});
        sheet->close();
    });
}

}  // namespace terratact
