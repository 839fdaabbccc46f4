// Tests texts from files that look like HTML: they are shown literally and load nothing.
#include <gtest/gtest.h>
#include <qwt_text.h>
#include <sys/stat.h>

#include <QApplication>
#include <QHelpEvent>
#include <QLabel>
#include <QToolTip>
#include <QWidget>
#include <cerrno>
#include <fcntl.h>
#include <unistd.h>

#include "tests/support/estimates.h"
#include "tests/support/gui.h"
#include "tests/support/temporary_directory.h"
#include "widgets/base/elided_label.h"
#include "widgets/base/palette.h"
#include "widgets/base/plain_label.h"
#include "widgets/base/theme.h"
#include "widgets/base/tips.h"
#include "widgets/control/status_header.h"
#include "widgets/signals/event_list.h"
#include "widgets/terrain/readings/estimate_strip.h"
#include "widgets/terrain/readings/verdict_strip.h"

namespace terratact {
namespace {

const QString kGreen =
    QStringLiteral("<table bgcolor='#00ff00' width='100%'><tr><td>CLEAR</td></tr></table>");

/// A FIFO without writer: opening it for reading blocks forever.
class HostileTexts : public testing::Test {
protected:
    void SetUp() override
    {
        applyLook(*qApp);
        ASSERT_EQ(::mkfifo(pipe().c_str(), 0600), 0);
    }
    /// Returns true if a reader has the FIFO open.
    bool isRead() const
    {
        const int fd = ::open(pipe().c_str(), O_WRONLY | O_NONBLOCK | O_CLOEXEC);
        if (fd >= 0) ::close(fd);
        return fd >= 0 || errno != ENXIO;
    }
    std::string pipe() const { return directory_.file("pipe"); }
    QString image() const
    {
        return QStringLiteral("<img src=\"file://%1\">").arg(QString::fromStdString(pipe()));
    }

private:
    TemporaryDirectory directory_;
};

int greenPixels(QWidget& widget)
{
    const QImage image = widget.grab().toImage().convertToFormat(QImage::Format_RGB32);
    int count = 0;
    for (int y = 0; y < image.height(); ++y)
        for (int x = 0; x < image.width(); ++x) count += image.pixel(x, y) == 0xff00ff00U;
    return count;
}

TEST_F(HostileTexts, anImageInATextIsNotLoaded)
{
    StatusHeader header;
    header.setSource(image());
    header.setModel(image(), Tone::Plain, image());
    header.setOverridden(image());
    header.setLink(image(), Tone::Good, image());
    EventList events;
    events.add(image(), EventSeverity::Bad, QTime(12, 0));
    VerdictStrip verdict;
    verdict.setNothing(image());
    ElidedLabel elided(image());
    for (QWidget* widget : std::initializer_list<QWidget*>{&header, &events, &verdict, &elided}) {
        widget->resize(900, 120);
        (void)widget->grab();
        for (const QLabel* label : widget->findChildren<QLabel*>())
            EXPECT_EQ(label->textFormat(), Qt::PlainText) << label->text().toStdString();
    }
    EXPECT_FALSE(isRead());
}

TEST_F(HostileTexts, aTipWithHtmlIsShownLiterally)
{
    QWidget widget;
    setTip(widget, image());
    EXPECT_EQ(tipOf(widget), image());
    EXPECT_TRUE(widget.toolTip().contains(QStringLiteral("&lt;img")));
    setTip(widget, QStringLiteral("a < b"));
    EXPECT_EQ(widget.toolTip(), QStringLiteral("a < b")) << "no tip changes without need";
    showTip({}, image(), &widget);
    EXPECT_TRUE(QToolTip::text().contains(QStringLiteral("&lt;img")));
    QToolTip::hideText();
    EXPECT_FALSE(isRead());
}

TEST_F(HostileTexts, plotsShowNoRichText)
{
    const QwtText plain(image(), QwtText::PlainText), guessed(image());
    const QFont font = QApplication::font();
    EXPECT_EQ(guessed.textSize(font), plain.textSize(font));
}

TEST_F(HostileTexts, markupPaintsNoGreenClear)
{
    QLabel rich(kGreen);
    rich.resize(400, 60);
    ASSERT_GT(greenPixels(rich), 1000) << "the text must be one that could";
    PlainLabel plain(kGreen);
    plain.resize(400, 60);
    EXPECT_EQ(greenPixels(plain), 0);
    VerdictStrip verdict;
    verdict.setNothing(kGreen);
    verdict.resize(900, 120);
    EXPECT_EQ(greenPixels(verdict), 0);
    EventList events;
    events.resize(900, 120);
    events.add(kGreen, EventSeverity::Note, QTime(12, 0));
    EXPECT_EQ(greenPixels(events), 0);
}

}  // namespace
}  // namespace terratact
