#include "widgets/control/covered.h"
#include "widgets/control/probe_card.h"

#include <gtest/gtest.h>

#include <QApplication>
#include <QDialog>
#include <QLabel>
#include <QMenu>
#include <QPushButton>

#include "tests/support/gui.h"
#include "widgets/base/held_button.h"
#include "widgets/base/theme.h"

namespace terratact {
namespace {

const ProbeProposal kProposal{.id = 7,
                              .bin = 9,
                              .height = 0.02,
                              .q10 = -0.05,
                              .q90 = 0.09,
                              .sd = 0.07,
                              .bitsBefore = 0.98,
                              .worth = ProbeWorth{9, 0.71, 0.31},
                              .others = {{10, 0.58, 0.52}, {8, 0.2, 0.9}}};

struct Probe : testing::Test {
    static void SetUpTestSuite() { applyLook(*qApp); }
    Probe()
    {
        card.resize(400, 320);
        card.approveButton()->setHoldTime(100);
        gui::showActive(card);
        QObject::connect(&card, &ProbeCard::approved, [this](quint64 id) { approved << id; });
        QObject::connect(&card, &ProbeCard::refused, [this](quint64 id) { refused << id; });
    }
    /// Shows the proposal and waits until it is visible.
    void ask(const ProbeProposal& proposal)
    {
        card.setProposal(proposal);
        ASSERT_TRUE(gui::eventually([&] { return card.shown() == proposal.id; }));
    }
    QString allText() const
    {
        QString text;
        for (const QLabel* label : card.findChildren<QLabel*>())
            if (label->isVisible()) text += label->text() + QLatin1Char('\n');
        return text;
    }
    ProbeCard card;
    QList<quint64> approved, refused;
};

TEST_F(Probe, showsANarrowBandInMillimetres)
{
    ProbeProposal known = kProposal;
    known.height = -0.25;
    known.sd = 0.0024;
    known.q10 = -0.253;
    known.q90 = -0.247;
    ask(known);
    EXPECT_TRUE(allText().contains("−0.253 … −0.247 m")) << allText().toStdString();
    EXPECT_TRUE(allText().contains("± 0.002 m")) << allText().toStdString();
}

TEST_F(Probe, showsBinGainAndCost)
{
    card.setProposal(kProposal);
    card.setTimeLeft(23.4);
    const QString text = allText();
    for (const char* words : {"bin 0.6 m", "+0.02 m", "−0.05 … +0.09 m", "45 s", "0:24 left",
                              "total variance −71 %", "0.98 → 0.31 bit: 0.89/min"})
        EXPECT_TRUE(text.contains(QString::fromUtf8(words))) << words << " in\n"
                                                             << text.toStdString();
    EXPECT_TRUE(card.approveButton()->text().contains("0.6 m"));
}

TEST_F(Probe, voidProposalShowsWhyAndCannotBeApproved)
{
    const QList<Precondition> met{{Precondition::Level::Met, Message::verbatim("as then")}};
    const QList<Precondition> changed{
        {Precondition::Level::Met, Message::verbatim("the link is good")},
        {Precondition::Level::Missing, Message::verbatim("the model has changed")}};
    for (const bool narrow : {false, true}) {
        card.setNarrow(narrow);
        ASSERT_NO_FATAL_FAILURE(ask(kProposal));
        card.setPreconditions(met);
        card.setTimeLeft(20.0);
        EXPECT_FALSE(allText().contains("Cannot be approved"));
        card.approveButton()->setHoldTime(60000);
        QTest::mousePress(card.approveButton(), Qt::LeftButton);
        ASSERT_TRUE(card.approveButton()->isHeld());
        card.setPreconditions(changed);
        card.setTimeLeft(20.0);
        EXPECT_FALSE(card.approveButton()->isHeld()) << "a hold that was begun before is no word";
        QTest::mouseRelease(card.approveButton(), Qt::LeftButton);
        EXPECT_FALSE(card.approveButton()->isEnabled());
        EXPECT_TRUE(card.approveButton()->text().contains("void"));
        EXPECT_TRUE(card.approveButton()->toolTip().contains("the model has changed"));
        EXPECT_TRUE(allText().contains("Cannot be approved: the model has changed"));
        EXPECT_EQ(card.note()->text(), "void") << "no time runs";
        EXPECT_TRUE(card.accessibleDescription().contains("the model has changed"));
        EXPECT_FALSE(card.otherButton(0)->isEnabled());
        EXPECT_TRUE(card.refuseButton()->isEnabled());
        card.approveButton()->setHoldTime(30);
        QTest::mousePress(card.approveButton(), Qt::LeftButton);
        QTest::qWait(120);
        EXPECT_TRUE(approved.isEmpty());
        QTest::mouseRelease(card.approveButton(), Qt::LeftButton);
        card.setPreconditions(met);
        EXPECT_TRUE(card.approveButton()->isEnabled()) << "the old model is in use again";
        EXPECT_TRUE(card.otherButton(0)->isEnabled());
    }
    ProbeProposal another = kProposal;
    card.setPreconditions(changed);
    another.id = 8;
    card.setProposal(another);
    EXPECT_TRUE(card.approveButton()->isEnabled()) << "another question stands on its own grounds";
}

TEST_F(Probe, narrowCardShowsAllFactsInFewerWords)
{
    card.setNarrow(true);
    card.setFixedWidth(300);
    card.setProposal(kProposal);
    card.resize(300, 244);
    card.setTimeLeft(23.4);
    const QString text = allText();
    for (const char* words :
         {"at 0.6 m: +0.02 ± 0.07 m", "80 % in −0.05 … +0.09 m", "total variance −71 %", "45 s",
          "0.98 → 0.31 bit", "0.89/min", "0:24 left"})
        EXPECT_TRUE(text.contains(QString::fromUtf8(words))) << words << " in\n"
                                                             << text.toStdString();
    EXPECT_EQ(card.otherButton(0)->text(), "1: 0.7 m");
    EXPECT_TRUE(gui::eventually([&] { return gui::cramped(card).empty(); }));
    for (const std::string& trouble : gui::cramped(card)) ADD_FAILURE() << trouble;
}

TEST_F(Probe, fitsWithoutScrollingInA1280x720Window)
{
    ProbeProposal decided = kProposal;
    decided.answer = StepVerdict::Blocked;
    card.setFixedSize(404, 273);
    for (const ProbeProposal& proposal : {kProposal, decided}) {
        card.setProposal(proposal);
        EXPECT_TRUE(gui::eventually([&] { return gui::cramped(card).empty(); }));
        for (const std::string& trouble : gui::cramped(card)) ADD_FAILURE() << trouble;
    }
}

TEST_F(Probe, showsThatTheVerdictIsAlreadyDecided)
{
    ProbeProposal decided = kProposal;
    decided.answer = StepVerdict::Blocked;
    decided.bitsBefore = 0.003;
    decided.worth->bitsAfter = 0.001;
    for (const bool narrow : {false, true}) {
        card.setNarrow(narrow);
        card.setProposal(kProposal);
        EXPECT_FALSE(allText().contains("Already"));
        EXPECT_EQ(card.refuseButton()->property("role").toString(), "");
        card.setProposal(decided);
        EXPECT_TRUE(allText().contains("Already BLOCKED")) << allText().toStdString();
        EXPECT_FALSE(allText().contains(QStringLiteral("→"))) << allText().toStdString();
        EXPECT_TRUE(allText().contains("no gain"));
        EXPECT_EQ(card.refuseButton()->property("role").toString(), "primary");
        EXPECT_TRUE(card.approveButton()->isVisible()) << "one may still want the shape";
    }
    card.setNarrow(false);
    EXPECT_TRUE(allText().contains("a probe only refines the profile"));
    EXPECT_TRUE(card.refuseButton()->text().contains("keep BLOCKED"));

    decided.worth->bitsAfter = -0.2;  // it would still have information
    card.setProposal(decided);
    EXPECT_TRUE(allText().contains("a probe makes it more certain"));
    EXPECT_TRUE(allText().contains(QStringLiteral("→")));
    for (const std::string& text : gui::cutText(card)) ADD_FAILURE() << text;
}

TEST_F(Probe, listsTheOtherBinsAndTheirGain)
{
    QList<int> bins;
    QObject::connect(&card, &ProbeCard::otherChosen, [&](quint64 id, ProbePlace place) {
        EXPECT_EQ(id, 7u);
        EXPECT_EQ(place.side, ProbeSide::Middle);
        bins << place.bin;
    });
    card.setProposal(kProposal);
    EXPECT_TRUE(card.otherButton(0)->text().contains(QStringLiteral("0.7 m, −58 %")));
    EXPECT_TRUE(card.otherButton(0)->toolTip().contains("0.52 bit"));
    EXPECT_FALSE(card.otherButton(2)->isVisible());
    QTest::mouseClick(card.otherButton(1), Qt::LeftButton);
    EXPECT_EQ(bins, QList<int>{8});
    for (const std::string& text : gui::cutText(card)) ADD_FAILURE() << text;
}

TEST_F(Probe, namesTheSideEverywhere)
{
    ProbeProposal left = kProposal;
    left.side = ProbeSide::Left;
    left.others[0].side = ProbeSide::Right;
    std::vector<ProbePlace> chosen;
    QObject::connect(&card, &ProbeCard::otherChosen,
                     [&](quint64, ProbePlace place) { chosen.push_back(place); });
    card.setProposal(left);
    EXPECT_TRUE(card.approveButton()->text().contains("left at 0.6 m"))
        << card.approveButton()->text().toStdString();
    EXPECT_EQ(card.approveButton()->accessibleName(),
              "Hold to approve the probe of left bin 0.6 m");
    EXPECT_TRUE(allText().contains("left bin 0.6 m"));
    EXPECT_TRUE(card.otherButton(0)->text().contains(QStringLiteral("R 0.7, −58 %")));
    EXPECT_TRUE(
        card.otherButton(0)->accessibleName().startsWith("Ask for right bin 0.7 m instead"));
    QTest::mouseClick(card.otherButton(0), Qt::LeftButton);
    EXPECT_EQ(chosen, (std::vector<ProbePlace>{{10, ProbeSide::Right}}));
    card.setWorth(left, "why");
    EXPECT_TRUE(allText().contains("or right at 0.7 m"));
    card.setProbing({9, ProbeSide::Left}, 3.0, 45.0);
    EXPECT_TRUE(allText().contains("The arm is probing left bin 0.6 m"));
    for (const std::string& text : gui::cutText(card)) ADD_FAILURE() << text;
}

TEST_F(Probe, showsTheFactsReadOnlyWithoutAProposal)
{
    for (const bool narrow : {false, true}) {
        card.setNarrow(narrow);
        card.setProposal(kProposal);
        card.setTimeLeft(23.4);
        card.setWorth(kProposal, "approved elsewhere");
        EXPECT_TRUE(card.showsWorth());
        EXPECT_EQ(card.note()->text(), "no probe is proposed");
        EXPECT_FALSE(card.asks());
        EXPECT_FALSE(card.shown());
        const QString text = allText();
        for (const char* words : {"approved elsewhere", "0.6 m", "+0.02", "−0.05 … +0.09 m",
                                  "total variance −71 %", "45 s", "0.98 → 0.31 bit", "0.89/min",
                                  "or at 0.7 m: −58 %, 0.52 bit\nor at 0.5 m: −20 %, 0.90 bit"})
            EXPECT_TRUE(text.contains(QString::fromUtf8(words))) << words << " in\n"
                                                                 << text.toStdString();
        EXPECT_FALSE(text.contains("left")) << "no question runs out";
        EXPECT_TRUE(gui::eventually([&] { return gui::cramped(card).empty(); }));
        for (const std::string& trouble : gui::cramped(card)) ADD_FAILURE() << trouble;
    }
    for (const QPushButton* button : card.findChildren<QPushButton*>())
        EXPECT_FALSE(button->isVisible()) << button->text().toStdString();
    const int least = card.leastHeight();
    card.setProposal(kProposal);
    EXPECT_FALSE(card.showsWorth());
    EXPECT_TRUE(card.approveButton()->isVisible());
    EXPECT_EQ(card.leastHeight(), least) << "the question has its room before it comes";
    EXPECT_FALSE(allText().contains("approved elsewhere"));
    card.setWorth(kProposal, "approved elsewhere");
    card.setNothing("no estimate");
    EXPECT_FALSE(card.showsWorth());
    EXPECT_FALSE(allText().contains("bit"));
}

TEST_F(Probe, showsNoGainForAMethodWithoutOne)
{
    ProbeProposal plain = kProposal;
    plain.worth.reset();
    plain.others.clear();
    card.setProposal(plain);
    EXPECT_FALSE(allText().contains("bit:"));
    EXPECT_TRUE(allText().contains(QStringLiteral("± 0.03 m")));
}

TEST_F(Probe, unpaintedProposalCannotBeApproved)
{
    card.setProposal(kProposal);
    QTest::mousePress(card.approveButton(), Qt::LeftButton);
    EXPECT_FALSE(card.approveButton()->isHeld());
    QTest::mouseRelease(card.approveButton(), Qt::LeftButton);
}

TEST_F(Probe, coveredProposalIsNotApproved)
{
    ASSERT_NO_FATAL_FAILURE(ask(kProposal));
    QDialog beside(&card);
    beside.setGeometry(QRect(card.mapToGlobal(QPoint(card.width() + 50, 0)), QSize(200, 100)));
    beside.show();
    gui::showActive(card);
    EXPECT_EQ(card.shown(), kProposal.id);
    card.approveButton()->setHoldTime(300);
    QTest::mousePress(card.approveButton(), Qt::LeftButton);
    ASSERT_TRUE(card.approveButton()->isHeld());
    beside.move(card.mapToGlobal(QPoint()));
    EXPECT_TRUE(gui::eventually([&] { return !card.approveButton()->isHeld(); }));
    QTest::qWait(600);  // waits for an event that must not come
    EXPECT_TRUE(approved.isEmpty());
    QTest::mouseRelease(card.approveButton(), Qt::LeftButton);
    QTest::mousePress(card.approveButton(), Qt::LeftButton);
    EXPECT_FALSE(card.approveButton()->isHeld());
    QTest::mouseRelease(card.approveButton(), Qt::LeftButton);
    QTest::mouseClick(card.refuseButton(), Qt::LeftButton);
    EXPECT_EQ(refused, QList<quint64>{7}) << "no is no in any case";
    beside.close();
    QTest::mousePress(card.approveButton(), Qt::LeftButton);
    EXPECT_TRUE(gui::eventually([&] { return approved == QList<quint64>{7}; }));
}

TEST_F(Probe, isCoveredByAnOpenMenuOnTopOfIt)
{
    ASSERT_NO_FATAL_FAILURE(ask(kProposal));
    QMenu menu;  // has no parent
    menu.addAction("an entry");
    menu.popup(card.mapToGlobal(QPoint(20, 20)));
    ASSERT_TRUE(gui::eventually([&] { return menu.isVisible(); }));
    EXPECT_TRUE(isCovered(card));
    EXPECT_FALSE(card.shown());
    menu.close();
    EXPECT_TRUE(gui::eventually([&] { return card.shown() == kProposal.id; }));
    QMenu beside;
    beside.addAction("an entry");
    beside.popup(card.mapToGlobal(QPoint(card.width() + 20, 20)));
    ASSERT_TRUE(gui::eventually([&] { return beside.isVisible(); }));
    EXPECT_FALSE(isCovered(card));
    beside.close();
}

TEST_F(Probe, anAnswerCarriesTheProposalsNumber)
{
    ASSERT_NO_FATAL_FAILURE(ask(kProposal));
    QTest::mousePress(card.approveButton(), Qt::LeftButton);
    ASSERT_TRUE(gui::eventually([this] { return !approved.isEmpty(); }));
    EXPECT_EQ(approved, QList<quint64>{7});
    QTest::mouseClick(card.refuseButton(), Qt::LeftButton);
    EXPECT_EQ(refused, QList<quint64>{7});
}

TEST_F(Probe, aHoldBegunOnAnotherProposalDoesNotCount)
{
    card.approveButton()->setHoldTime(100000);
    ASSERT_NO_FATAL_FAILURE(ask(kProposal));
    QTest::mousePress(card.approveButton(), Qt::LeftButton);
    ASSERT_TRUE(card.approveButton()->isHeld());
    ProbeProposal other = kProposal;
    other.id = 8;
    other.bin = 10;
    card.setProposal(other);
    EXPECT_FALSE(card.approveButton()->isHeld());
}

TEST_F(Probe, theSameProposalAgainKeepsTheHold)
{
    card.approveButton()->setHoldTime(100000);
    ASSERT_NO_FATAL_FAILURE(ask(kProposal));
    QTest::mousePress(card.approveButton(), Qt::LeftButton);
    card.setProposal(kProposal);
    card.setTimeLeft(3.0);
    EXPECT_TRUE(card.approveButton()->isHeld());
    ProbeProposal decided = kProposal;
    decided.answer = StepVerdict::Clear;
    card.setProposal(decided);
    EXPECT_TRUE(card.approveButton()->isHeld()) << "it is still the same question";
}

TEST_F(Probe, withoutAProposalThereIsNothingToApprove)
{
    card.setProposal(kProposal);
    card.setNothing("no probe is needed");
    EXPECT_FALSE(card.asks());
    EXPECT_FALSE(card.approveButton()->isVisible());
    card.approveButton()->hold();
    EXPECT_FALSE(card.approveButton()->isHeld());
    EXPECT_TRUE(allText().contains("no probe is needed"));
}

TEST_F(Probe, showsTheArmOnItsWay)
{
    card.setProbing({9}, 31.0, 45.0);
    EXPECT_TRUE(allText().contains("bin 0.6 m"));
    EXPECT_FALSE(card.asks());
}

TEST_F(Probe, hostileNumbersReadAsNothing)
{
    for (const double bad : gui::kHostile) {
        ProbeProposal p{.id = 9,
                        .bin = 9,
                        .height = bad,
                        .q10 = bad,
                        .q90 = bad,
                        .sd = bad,
                        .seconds = bad,
                        .bitsBefore = bad,
                        .worth = ProbeWorth{9, bad, bad},
                        .others = {{10, bad, bad}}};
        card.setProposal(p);
        card.setTimeLeft(bad);
        ASSERT_FALSE(gui::painted(card).isNull());
        card.setWorth(p, {});
        ASSERT_FALSE(gui::painted(card).isNull());
        card.setProbing({9}, bad, bad);
        ASSERT_FALSE(gui::painted(card).isNull());
    }
}

}  // namespace
}  // namespace terratact
