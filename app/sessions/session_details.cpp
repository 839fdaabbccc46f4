#include "app/sessions/session_details.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QPainter>
#include <QVBoxLayout>
#include <memory>

#include "app/display/format.h"
#include "app/display/translated.h"
#include "app/sessions/session_list.h"
#include "widgets/base/plain_label.h"
#include "widgets/base/plain_table.h"
#include "widgets/base/theme.h"
#include "widgets/terrain/readings/terrain_thumbnail.h"

namespace terratact {
namespace {

constexpr int kPictureWide = 230, kPictureHigh = 92;  // [px] at 100 %
constexpr qsizetype kMaxShown = 400;                  // characters of the notes

/// Returns what is known besides the columns of the list, a line for each fact.
QStringList factsOf(const ListedSession& session)
{
    if (session.isRecorded)
        return {SessionDetails::tr("This console is recording it. It can be reviewed meanwhile.")};
    if (!session.summary) return {translatedLine(session.trouble)};
    const SessionSummary& summary = *session.summary;
    QStringList facts{SessionDetails::tr("%1 · %2 · %3 frames, %4 scenes, %5 estimates")
                          .arg(format::sourceName(summary.source), format::line(summary.program))
                          .arg(summary.frames)
                          .arg(summary.scenes)
                          .arg(summary.estimates)};
    if (const QString verdicts = verdictsText(session); !verdicts.isEmpty())
        facts << SessionDetails::tr("last verdicts of the scenes: %1").arg(verdicts);
    if (summary.proposals > 0)
        facts << SessionDetails::tr("probes: %1 approved of %2 proposed; alarms raised: %3")
                     .arg(summary.probes)
                     .arg(summary.proposals)
                     .arg(summary.alarms);
    if (summary.closing == SessionClosing::Open)
        facts << SessionDetails::tr("It is still being recorded, or its program died.");
    if (summary.closing == SessionClosing::Torn)
        facts << SessionDetails::tr(
            "Its journal is missing or damaged: the end is not in the file.");
    if (summary.damage) facts << translatedLine(*summary.damage);
    if (const QString notes = notesText(session); !notes.isEmpty())
        facts << SessionDetails::tr("notes: %1").arg(notes.left(kMaxShown));
    return facts;
}

}  // namespace

/// The larger thumbnail.
class SessionDetails::Picture final : public QWidget {
public:
    using QWidget::QWidget;
    void show(std::optional<LastEstimate> last)
    {
        last_ = std::move(last);
        setAccessibleName(last_ ? SessionDetails::tr("Ground of the last estimate")
                                : SessionDetails::tr("No estimate"));
        update();
    }

protected:
    void paintEvent(QPaintEvent*) override
    {
        if (!last_) return;
        QPainter painter(this);
        drawTerrainThumbnail(painter, QRectF(rect()), last_->estimate);
    }

private:
    std::optional<LastEstimate> last_;
};

SessionDetails::SessionDetails(QWidget* parent) : QWidget(parent)
{
    picture_ = new Picture(this);
    heading_ = new PlainLabel(this);
    heading_->setProperty("heading", true);
    text_ = new PlainLabel(this);
    text_->setWordWrap(true);
    text_->setAlignment(Qt::AlignTop | Qt::AlignLeft);
    text_->setAccessibleName(tr("The chosen recording"));
    auto* column = new QVBoxLayout;
    column->setSpacing(2);
    column->addWidget(heading_);
    column->addWidget(text_, 1);
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(12);
    row->addWidget(picture_, 0, Qt::AlignTop);
    row->addLayout(column, 1);
    resizeToFont();
}

SessionDetails::~SessionDetails() = default;

void SessionDetails::show(const ListedSession& session)
{
    heading_->setText(QStringLiteral("%1 · %2").arg(
        format::fileName(QString::fromStdString(session.path)), beginText(session)));
    text_->setText(factsOf(session).join(QLatin1Char('\n')));
    picture_->show(session.summary ? session.summary->last : std::nullopt);
}

void SessionDetails::showNothing(const QString& why)
{
    heading_->setText({});
    text_->setText(why);
    picture_->show(std::nullopt);
}

QString SessionDetails::text() const
{
    return heading_->text() + QLatin1Char('\n') + text_->text();
}

void SessionDetails::changeEvent(QEvent* event)
{
    QWidget::changeEvent(event);
    if (changesFont(*event)) resizeToFont();
}

void SessionDetails::resizeToFont()
{
    picture_->setFixedSize(scaled(kPictureWide), scaled(kPictureHigh));
    setFixedHeight(std::max(scaled(kPictureHigh), fontMetrics().lineSpacing() * 7));
}

}  // namespace terratact
