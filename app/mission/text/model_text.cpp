#include "app/mission/text/model_text.h"

#include <QStringList>
#include <algorithm>

#include "app/display/format.h"
#include "app/display/translated.h"
#include "core/infer/verdict/obstacle.h"

namespace terratact {
namespace {

constexpr std::ptrdiff_t kShownScores = 6;  // newest scores shown
constexpr qsizetype kDay = 10;              // characters of "2026-11-22"
constexpr int kShownHash = 16;              // digits

QString day(const std::string& date)
{
    return format::text(date).left(kDay);
}

QString shortHash(const std::string& hash)
{
    return format::text(hash).left(kShownHash);
}

}  // namespace

QString ModelWords::card(const ModelFacts& facts)
{
    const ModelCard& card = facts.card;
    const QString unknown = tr("unknown");
    QStringList lines{format::text(facts.path)};
    lines << tr("trained %1; ground: %2")
                 .arg(card.trained.empty() ? unknown : day(card.trained),
                      card.terrain.empty() ? unknown : format::text(card.terrain));
    lines << tr("%1 scenes, %2 % with a step above %3; median relief %4")
                 .arg(QString::number(facts.scenes), format::percent(facts.ground.stepShare),
                      format::length(kStepLimit, 2), format::length(facts.ground.relief, 2));
    const auto shown = std::min<std::ptrdiff_t>(kShownScores, std::ssize(card.scores));
    for (auto s = card.scores.end() - shown; s != card.scores.end(); ++s) {
        lines << tr("%1: mean error %2 mm, the 80 % band holds %3 % – %4 scenes of %5, %6")
                     .arg(format::text(s->method), format::number(1000.0 * s->meanError, 1),
                          format::percent(s->coverage), QString::number(s->scenes),
                          format::text(s->data), day(s->date));
        if (s->trainingScenes > 0)
            lines.back() += tr(" – %1 of them are training scenes or near copies")
                                .arg(QString::number(s->trainingScenes));
        else if (facts.learntFrom(*s))
            lines.back() += tr(" – the scenes it was trained on");
    }
    if (shown == 0) lines << tr("never evaluated: its errors are unknown");
    if (!facts.trouble.empty())
        lines << tr("its card is not used: %1").arg(translated(facts.trouble));
    lines
        << tr("content %1; scenes %2").arg(shortHash(facts.contentHash), shortHash(facts.dataHash));
    lines << tr("made by: %1").arg(format::text(facts.command));
    return lines.join(QLatin1Char('\n'));
}

}  // namespace terratact
