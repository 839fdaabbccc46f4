#include "widgets/control/precondition_grid.h"

#include <QLabel>

#include "app/display/translated.h"
#include "widgets/base/palette.h"
#include "widgets/base/plain_label.h"
#include "widgets/base/theme.h"

namespace terratact {

PreconditionGrid::PreconditionGrid()
{
    setContentsMargins(0, 0, 0, 0);
    setHorizontalSpacing(8);
    setVerticalSpacing(2);
    setColumnStretch(1, 1);
}

void PreconditionGrid::addLine()
{
    const int row = count() / 2;
    auto* mark = new PlainLabel(parentWidget());
    auto* reason = new PlainLabel(parentWidget());
    reason->setWordWrap(true);
    addWidget(mark, row, 0, Qt::AlignTop);
    addWidget(reason, row, 1);
}

void PreconditionGrid::setPreconditions(const QList<Precondition>& preconditions)
{
    if (preconditions == shown_) return;
    while (count() < 2 * preconditions.size()) addLine();
    for (int row = 0; row < count() / 2; ++row) {
        auto* mark = qobject_cast<QLabel*>(itemAtPosition(row, 0)->widget());
        auto* reason = qobject_cast<QLabel*>(itemAtPosition(row, 1)->widget());
        const bool used = row < preconditions.size();
        mark->setVisible(used);
        reason->setVisible(used);
        if (!used) continue;
        const Precondition& condition = preconditions[row];
        static constexpr Tone kTones[]{Tone::Good, Tone::Warning, Tone::Warning, Tone::Bad};
        const QString spoken[]{tr("met"), tr("overridden"), tr("doubtful"), tr("missing")};
        const auto level = static_cast<std::size_t>(condition.level);
        mark->setText(markOf(condition.level));
        reason->setText(condition.level == Precondition::Level::Overridden
                            ? tr("%1 (overridden)").arg(translated(condition.text))
                            : translated(condition.text));
        reason->setAccessibleName(spoken[level] + QStringLiteral(": ")
                                  + translated(condition.text));
        setTone(*mark, kTones[level]);
        setTone(*reason, condition.level == Precondition::Level::Met ? Tone::Plain : kTones[level]);
    }
    shown_ = preconditions;
}

}  // namespace terratact
