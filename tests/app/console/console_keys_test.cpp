// Tests the keys: STOP acts in every state; other keys act only where they should.
#include "app/console/main_window.h"

#include <gtest/gtest.h>

#include <QApplication>
#include <QClipboard>
#include <QDialog>
#include <QFileDialog>
#include <QLineEdit>
#include <QMenu>
#include <QPushButton>
#include <QRegularExpression>
#include <QScrollArea>
#include <functional>
#include <utility>

#include "app/console/pages/settings_page.h"
#include "app/display/format.h"
#include "app/pages/numbers_page.h"
#include "app/shell/text_sheet.h"
#include "core/learn/model/file/model_file.h"
#include "tests/support/benches/console_bench.h"
#include "tests/support/gui.h"
#include "tests/support/scripted_source.h"
#include "tests/support/temporary_directory.h"
#include "tests/support/toy_model.h"
#include "widgets/base/held_button.h"
#include "widgets/base/navigation_rail.h"
#include "widgets/control/atem_panel.h"
#include "widgets/control/covered.h"
#include "widgets/control/drive_pad.h"
#include "widgets/control/probe_card.h"
#include "widgets/control/status_header.h"
#include "widgets/signals/event_list.h"
#include "widgets/signals/force_bars.h"
#include "widgets/terrain/readings/numbers_table.h"
#include "widgets/terrain/readings/verdict_strip.h"
#include "widgets/terrain/terrain_profile_view.h"

namespace terratact {
namespace {

using gui::eventually;

TEST_F(Console, thePagesAreReachedByTheirKeys)
{
    open(fastRobot(robot, 2.1));
    for (int page = 0; page < window->rail()->pages(); ++page) {
        if (window->rail()->button(page)->isHidden()) continue;
        QTest::keyClick(window.get(), window->rail()->keyOf(page));
        EXPECT_EQ(window->rail()->chosen(), page);
        EXPECT_TRUE(window->header()->stopButton()->isVisible());
    }
    QTest::keyClick(window.get(), Qt::Key_F3);
    EXPECT_TRUE(window->numbers()->isVisible());
    EXPECT_FALSE(window->terrain()->isVisible());
}

TEST_F(Console, spaceOnAButtonWithTheFocusMeansThatButton)
{
    open(fastRobot(robot, 2.1));
    proposeByKeyboard();
    window->probeCard()->refuseButton()->setFocus();
    QTest::keyClick(window->probeCard()->refuseButton(), Qt::Key_Space);
    ASSERT_TRUE(reaches(AtemPhase::Presenting));
    EXPECT_FALSE(window->exploration().state().probed);
}

TEST_F(Console, stopWorksByKeyFromADialogAndTakesAHoldToRelease)
{
    open(fastRobot(robot, 2.1));
    proposeByKeyboard();
    QDialog dialog(window.get());
    dialog.setModal(true);
    gui::showActive(dialog);
    QTest::keyClick(&dialog, Qt::Key_F12);
    ASSERT_TRUE(robotIs(RobotActivity::Stopped));
    ASSERT_TRUE(reaches(AtemPhase::Stopped));
    dialog.close();
    gui::showActive(*window);
    EXPECT_FALSE(window->drivePad()->forwardButton()->isEnabled());
    ASSERT_TRUE(eventually([&] { return window->atemPanel()->releaseButton()->isVisible(); }));
    QTest::keyClick(window.get(), Qt::Key_R);
    QTest::keyClick(window.get(), Qt::Key_A);
    EXPECT_EQ(window->exploration().state().phase, AtemPhase::Stopped);
    QTest::keyPress(window.get(), Qt::Key_R);
    ASSERT_TRUE(reaches(AtemPhase::Idle));
    QTest::keyRelease(window.get(), Qt::Key_R);
    ASSERT_TRUE(robotIs(RobotActivity::Halted));
}

TEST_F(Console, stopActsWhileOtherKeysAreHeld)
{
    ScriptedSource* source = openScripted();
    for (const auto modifiers :
         {Qt::ControlModifier | Qt::NoModifier, Qt::AltModifier | Qt::NoModifier,
          Qt::MetaModifier | Qt::NoModifier, Qt::ControlModifier | Qt::ShiftModifier})
        for (const Qt::Key key : gui::kStopKeys) {
            source->consumeCommands();
            QTest::keyClick(window.get(), key, modifiers);
            const auto commands = source->consumeCommands();
            ASSERT_FALSE(commands.empty()) << key << " with " << modifiers.toInt();
            EXPECT_TRUE(std::holds_alternative<StopCommand>(commands.front()));
        }
}

TEST_F(Console, stopWorksByKeyAndByMouseBesideEveryFileDialog)
{
    openScripted();
    EXPECT_TRUE(QCoreApplication::testAttribute(Qt::AA_DontUseNativeDialogs))
        << "no key of a desktop's own dialog reaches this program";
    const auto press = [](QPushButton* button) {
        return [button] { QTest::mouseClick(button, Qt::LeftButton); };
    };
    const std::pair<const char*, std::function<void()>> ways[]{
        {"a recording", [&] { QTest::keyClick(window.get(), Qt::Key_O, Qt::ControlModifier); }},
        {"a model", press(window->settings()->modelButton())},
        {"a robot", press(window->settings()->robotButton())}};
    for (const int letters : {100, 200})
        for (const auto& [what, opens] : ways) {
            window->setRoom({1200, 680});
            window->preferences().change([=](Preferences& p) { p.fontScale = letters; });
            window->resize(1200, 680);
            QTest::keyClick(window.get(), Qt::Key_F7);
            opens();
            opens();
            const auto dialogs = window->findChildren<QDialog*>();
            ASSERT_EQ(dialogs.size(), 1) << what << ": one of a kind";
            QDialog& dialog = *dialogs.front();
            const bool asksForFile = qobject_cast<QFileDialog*>(&dialog) != nullptr;
            auto* const field = dialog.findChild<QLineEdit*>(
                asksForFile ? QStringLiteral("fileNameEdit") : QString());
            ASSERT_TRUE(field);
            ASSERT_TRUE(QTest::qWaitForWindowExposed(&dialog));
            EXPECT_EQ(QApplication::activeModalWidget(), nullptr) << what;
            for (const Qt::Key key : gui::kStopKeys) {
                QTest::keyClick(field, key);
                EXPECT_EQ(stopsPressed(), 1) << what << ", " << key;
            }
            clickStop();
            EXPECT_EQ(stopsPressed(), 1) << what;
            EXPECT_FALSE(dialog.frameGeometry().intersects(onScreen(*window->header())))
                << what << " lies upon STOP, letters " << letters;
            if (const QString folder = qEnvironmentVariable("TERRATACT_PICTURES");
                !folder.isEmpty())
                dialog.grab().save(
                    QStringLiteral("%1/choose %2 %3.png").arg(folder, what).arg(letters));
            dialog.reject();
            ASSERT_TRUE(eventually([&] { return window->findChildren<QDialog*>().empty(); }));
        }
}

TEST_F(Console, aMissingFileIsReportedInTheDialogItself)
{
    openScripted();
    const TemporaryDirectory directory;
    const QString before = window->preferences().current().model;
    QTest::keyClick(window.get(), Qt::Key_F7);
    QTest::mouseClick(window->settings()->modelButton(), Qt::LeftButton);
    auto* dialog = window->findChild<QFileDialog*>();
    ASSERT_TRUE(dialog && QTest::qWaitForWindowExposed(dialog));
    auto* name = dialog->findChild<QLineEdit*>("fileNameEdit");
    ASSERT_TRUE(name);
    const auto type = [&](const std::string& file) {
        name->clear();
        QTest::keyClicks(name, QString::fromStdString(file));
    };
    const QString usual = dialog->labelText(QFileDialog::FileName);
    type(directory.file("none.ttm"));
    QTest::keyClick(name, Qt::Key_Return);
    EXPECT_EQ(QApplication::activeModalWidget(), nullptr)
        << "which STOP could not be clicked beside";
    EXPECT_TRUE(dialog->isVisible());
    EXPECT_EQ(dialog->labelText(QFileDialog::FileName), "There is no file:");
    clickStop();
    EXPECT_EQ(stopsPressed(), 1);
    EXPECT_EQ(window->preferences().current().model, before);
    const std::string model = directory.file("some.ttm");
    ASSERT_TRUE(writeModel(model, toyModel()));
    type("s");
    EXPECT_EQ(dialog->labelText(QFileDialog::FileName), usual);
    name->setText(QString::fromStdString(model));
    QTest::keyClick(name, Qt::Key_Return);
    EXPECT_TRUE(
        eventually([&] { return window->preferences().current().model.toStdString() == model; }));
}

TEST_F(Console, stopWorksByKeyAndByMouseWhileAMenuIsOpen)
{
    openScripted();
    for (QPushButton* button : {window->header()->qualityButton(), window->viewButton()})
        for (const auto key :
             {std::optional(Qt::Key_F12), std::optional(Qt::Key_Pause), std::optional<Qt::Key>()}) {
            ASSERT_TRUE(eventually([&] { return button->isVisible(); }));
            QMenu& menu = *button->menu();
            menu.popup(button->mapToGlobal(QPoint(0, button->height())));
            ASSERT_TRUE(eventually([&] { return menu.isVisible(); }));
            if (key)
                QTest::keyClick(&menu, *key);
            else
                clickStop();
            EXPECT_TRUE(eventually([&] { return stops > 0; }))
                << button->accessibleName().toStdString() << (key ? ", key" : ", mouse");
            EXPECT_EQ(stopsPressed(), 1);
            menu.hide();
        }
}

TEST_F(Console, theKeyThatExploresShowsWhyItHasNoEffect)
{
    open(fastRobot(robot, 2.1));
    ASSERT_TRUE(readyToExplore());
    QTest::keyClick(window.get(), Qt::Key_F7);
    EXPECT_TRUE(gui::eventually([&] {  // a busy machine's telemetry may be late
        QTest::keyClick(window.get(), Qt::Key_A);
        return says("not explored: it is done on the page Terrain (F2)");
    }));
    EXPECT_EQ(window->exploration().state().phase, AtemPhase::Idle);
    QTest::keyClick(window.get(), Qt::Key_F2);
    window->exploration().stop();
    ASSERT_TRUE(reaches(AtemPhase::Stopped));
    EXPECT_TRUE(gui::eventually([&] {
        const std::string why = window->exploration().whyNotExploring().value().english();
        EXPECT_FALSE(why.empty());
        QTest::keyClick(window.get(), Qt::Key_A);
        return says("not explored: " + QString::fromStdString(why));
    }));
}

TEST_F(Console, aDriveKeyWithoutEffectShowsTheReason)
{
    open(fastRobot(robot, 2.1));
    ASSERT_TRUE(readyToExplore());
    const auto newest = [this] { return window->events()->item(0)->text().toStdString(); };
    const auto expectWhy = [&](const std::string& why) {
        for (const Qt::Key key : {Qt::Key_W, Qt::Key_S, Qt::Key_Up, Qt::Key_Down}) {
            window->events()->clear();
            window->events()->add("nothing", EventSeverity::Note, QTime(12, 0));
            QTest::keyClick(window.get(), key);
            EXPECT_NE(newest().find("not driven: " + why), std::string::npos)
                << newest() << ", key " << key;
        }
    };
    QTest::keyClick(window.get(), Qt::Key_F7);
    expectWhy("it is done on the page Terrain (F2)");
    QTest::keyClick(window.get(), Qt::Key_F2);
    proposeByKeyboard();
    const std::string why = window->exploration().whyNotDriving().value().english();
    ASSERT_FALSE(why.empty());
    expectWhy(why);
    EXPECT_TRUE(says("not driven: ")) << "a banner, too";
    const QString tip = window->drivePad()->forwardButton()->toolTip();
    EXPECT_TRUE(tip.contains(QString::fromStdString(why))) << tip.toStdString();
}

TEST_F(Console, keysActOnlyOnVisibleControls)
{
    open(fastRobot(robot, 2.1));
    ASSERT_TRUE(readyToExplore());
    const double limit = window->exploration().options().stepLimit;
    QTest::keyClick(window.get(), Qt::Key_F7);
    for (const Qt::Key key : {Qt::Key_PageUp, Qt::Key_PageDown, Qt::Key_A, Qt::Key_W})
        QTest::keyPress(window.get(), key);
    QTest::qWait(100);  // waits for an event that must not come
    EXPECT_EQ(window->exploration().options().stepLimit, limit);
    EXPECT_EQ(window->exploration().state().phase, AtemPhase::Idle);
    EXPECT_TRUE(robotIs(RobotActivity::Halted));
    QTest::keyClick(window.get(), Qt::Key_F2);
    proposeByKeyboard();

    QTest::keyClick(window.get(), Qt::Key_F7);
    const quint64 asked = window->exploration().proposal()->id;
    for (const Qt::Key key : {Qt::Key_1, Qt::Key_2, Qt::Key_3, Qt::Key_N})
        QTest::keyClick(window.get(), key);
    QTest::qWait(100);  // waits for an event that must not come
    ASSERT_TRUE(window->exploration().proposal());
    EXPECT_EQ(window->exploration().proposal()->id, asked);
    EXPECT_EQ(window->exploration().state().phase, AtemPhase::ProposingProbe);
    QTest::keyClick(window.get(), Qt::Key_Escape);
    EXPECT_TRUE(reaches(AtemPhase::Idle)) << "what runs is aborted from anywhere";
}

TEST_F(Console, coveredProposalCanBeRefusedButNotApproved)
{
    open(fastRobot(robot, 2.1));
    proposeByKeyboard();
    const ProbeCard& card = *window->probeCard();
    QDialog above(window.get());
    above.setGeometry(QRect(card.mapToGlobal(QPoint()), card.size() / 2));
    above.show();
    gui::showActive(*window);
    ASSERT_TRUE(eventually([&] { return isCovered(card); }));
    EXPECT_TRUE(
        eventually([&] { return says("unless approved: close the window that covers it"); }));
    EXPECT_FALSE(says("F2 shows the question"));
    QTest::keyPress(window.get(), Qt::Key_Space);
    QTest::qWait(500);  // longer than the hold time
    QTest::keyRelease(window.get(), Qt::Key_Space);
    EXPECT_EQ(window->exploration().state().phase, AtemPhase::ProposingProbe);
    QTest::keyClick(window.get(), Qt::Key_N);
    ASSERT_TRUE(reaches(AtemPhase::Presenting));
    EXPECT_FALSE(window->exploration().state().probed);
}

TEST_F(Console, stopOfAnOpenedWindowActsLikeTheConsolesOwn)
{
    openScripted();
    auto caller = StopCaller::open();
    ASSERT_TRUE(caller);
    ASSERT_TRUE(caller->press(stopLineName()));
    EXPECT_TRUE(eventually([&] { return caller->isTaken(); }));
    EXPECT_EQ(stopsPressed(), 1);
    EXPECT_TRUE(reaches(AtemPhase::Stopped));
}

TEST_F(Console, stopActsOnTheMousePress)
{
    open(fastRobot(robot, 2.1));
    QTest::mousePress(window->header()->stopButton(), Qt::LeftButton);
    EXPECT_TRUE(robotIs(RobotActivity::Stopped)) << "before the button is released";
    QTest::mouseRelease(window->header()->stopButton(), Qt::LeftButton);
}

TEST_F(Console, drivingEndsWhenTheWindowLosesTheFocus)
{
    open(fastRobot(robot, 2.0));
    ASSERT_TRUE(readyToExplore());
    QTest::keyPress(window.get(), Qt::Key_W);
    ASSERT_TRUE(robotIs(RobotActivity::Driving));
    QWidget other;
    gui::showActive(other);
    EXPECT_TRUE(robotIs(RobotActivity::Halted));
}

TEST_F(Console, drivingEndsWhereverTheKeyIsReleased)
{
    open(fastRobot(robot, 2.0));
    ASSERT_TRUE(readyToExplore());
    QTest::keyPress(window.get(), Qt::Key_W);
    ASSERT_TRUE(robotIs(RobotActivity::Driving));
    QTest::keyRelease(window.get(), Qt::Key_W, Qt::ControlModifier);
    EXPECT_TRUE(robotIs(RobotActivity::Halted)) << "with another key held";

    QTest::keyPress(window.get(), Qt::Key_W);
    ASSERT_TRUE(robotIs(RobotActivity::Driving));
    QMenu* menu = window->header()->qualityButton()->menu();
    menu->popup(window->mapToGlobal(QPoint(10, 10)));
    QTest::keyRelease(menu, Qt::Key_W);
    EXPECT_TRUE(robotIs(RobotActivity::Halted)) << "over a menu";
    menu->hide();
}

TEST_F(Console, theKeysAreListedAndStopWorksWhileTheyAre)
{
    open(fastRobot(robot, 2.1));
    QTest::keyClick(window.get(), Qt::Key_F1);
    const auto lists = [&] {
        for (QWidget* other : QApplication::topLevelWidgets())
            if (other != window.get() && other->isVisible()) return other;
        return static_cast<QWidget*>(nullptr);
    };
    ASSERT_TRUE(eventually([&] { return lists() != nullptr; }));
    EXPECT_TRUE(window->keys().html().contains("F12 or Pause"));
    QTest::keyClick(lists(), Qt::Key_Pause);
    EXPECT_TRUE(robotIs(RobotActivity::Stopped));
    lists()->close();
}

TEST_F(Console, keySheetNamesTheKeysThatMoveInTimeInAReview)
{
    openScripted();
    QTest::keyClick(window.get(), Qt::Key_F1);
    const auto* sheet = window->findChild<TextSheet*>();
    ASSERT_TRUE(sheet);
    const QString note = sheet->plainText().section("In a review", 1);
    for (const char* key : {"A", "B", "F", "M", "P", "K", "Space"})
        EXPECT_TRUE(note.contains(QRegularExpression(QStringLiteral("\\b%1\\b").arg(key)))) << key;
}

TEST_F(Console, keySheetLeavesTheHeaderFreeAndScrolls)
{
    openScripted();
    window->setRoom({1200, 680});
    for (const int letters : {100, 200}) {
        window->preferences().change([=](Preferences& p) { p.fontScale = letters; });
        ASSERT_TRUE(eventually([&] { return !window->isFittingFont(); }));
        window->resize(1200, 680);
        QTest::keyClick(window.get(), Qt::Key_F1);
        auto* sheet = window->findChild<TextSheet*>();
        ASSERT_TRUE(sheet && QTest::qWaitForWindowExposed(sheet)) << letters;
        EXPECT_TRUE(sheet->isWindow());
        EXPECT_FALSE(sheet->frameGeometry().intersects(onScreen(*window->header()))) << letters;
        EXPECT_TRUE(onScreen(*window).contains(sheet->frameGeometry())) << letters;
        const QScrollArea& area = *sheet->area();
        EXPECT_EQ(area.horizontalScrollBar()->maximum(), 0) << letters << ": lines are whole";
        const QWidget& text = *area.widget();
        EXPECT_GE(text.height(), text.hasHeightForWidth() ? text.heightForWidth(text.width())
                                                          : text.sizeHint().height())
            << letters;
        EXPECT_LE(text.height(), area.viewport()->height() + area.verticalScrollBar()->maximum())
            << letters;
        if (const QString folder = qEnvironmentVariable("TERRATACT_PICTURES"); !folder.isEmpty()) {
            QPixmap both = window->grab();
            sheet->render(&both, sheet->pos() - window->pos());
            both.save(QStringLiteral("%1/keys_%2.png").arg(folder).arg(letters));
        }
        clickStop();
        EXPECT_EQ(stopsPressed(), 1) << letters;
        if (const int below = area.verticalScrollBar()->maximum(); below > 0) {
            QTest::keyClick(sheet->focusWidget(), Qt::Key_PageDown);
            EXPECT_GT(area.verticalScrollBar()->value(), 0) << "by key, too";
        }
        QTest::keyClick(sheet, Qt::Key_Escape);
        EXPECT_FALSE(sheet->isVisible());
    }
}

TEST_F(Console, ctrlCCopiesTheNumbersWhileTheyAreSeen)
{
    openScripted();
    QApplication::clipboard()->setText("before");
    const auto copy = [&] {
        QTest::keyClick(window->windowHandle(), Qt::Key_C, Qt::ControlModifier);
        return QApplication::clipboard()->text();
    };
    EXPECT_EQ(copy(), "before") << "they are not seen";
    QTest::keyClick(window.get(), Qt::Key_F3);
    ASSERT_TRUE(eventually([&] { return window->numbers()->isVisible(); }));
    EXPECT_EQ(copy(), window->numbers()->table()->text());
    EXPECT_TRUE(window->keys().html().contains("copy the numbers"));
    QTest::keyClick(window.get(), Qt::Key_F7);
    QLineEdit field(window.get());
    field.setText("typed");
    field.show();
    field.setFocus();
    field.selectAll();
    EXPECT_EQ(copy(), "typed") << "what a field has is its own";
}

}  // namespace
}  // namespace terratact
