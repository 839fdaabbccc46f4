#include <QCoreApplication>
#include <QRegularExpression>
#include <QStringList>

#include "widgets/words.h"

namespace terratact {
namespace {

// What the core says, for the translators: it is free of Qt and speaks English.  %1, %2, … stand for the numbers.
[[maybe_unused]] constexpr const char* kSentences[] = {
    QT_TRANSLATE_NOOP("core", "fast"),
    QT_TRANSLATE_NOOP("core", "balanced"),
    QT_TRANSLATE_NOOP("core", "accurate"),
    QT_TRANSLATE_NOOP("core", "the chains have not converged"),
    QT_TRANSLATE_NOOP("core", "the robot reports no odometry"),
    QT_TRANSLATE_NOOP("core", "the robot has driven too far since the last estimate"),
    QT_TRANSLATE_NOOP("core", "the last estimate has become too uncertain"),
    QT_TRANSLATE_NOOP("core", "the robot has tilted too much since the last estimate"),
    QT_TRANSLATE_NOOP("core", "the robot has turned since the last estimate"),
    QT_TRANSLATE_NOOP("core", "telemetry was missing while the robot drove"),
    QT_TRANSLATE_NOOP("core", "nothing of the last estimate is left in view"),
    QT_TRANSLATE_NOOP("core", "roll %1°: the ground is not the same left and right"),
    QT_TRANSLATE_NOOP(
        "core", "left and right flippers differ by %1°: the ground is not the same left and right"),
    QT_TRANSLATE_NOOP("core", "contact and arm disagree about bin %1 m by %2 mm"),
    QT_TRANSLATE_NOOP("core", "the arm found bin %1 m %2 mm above the robot's own lower edge"),
    QT_TRANSLATE_NOOP("core", "contact at x %1 m lies %2 mm above the robot's own lower edge"),
    QT_TRANSLATE_NOOP("core",
                      "unlike the training scenes: %1 times the distance that %2 % of them exceed"),
    QT_TRANSLATE_NOOP(
        "core",
        "a step ahead of more than %1 mm: probability %2 ± %3, likeliest between %4 and %5 m (%6)"),
    // clang-format off
    QT_TRANSLATE_NOOP("core", "a step ahead of more than %1 mm: probability %2 ± < %3, likeliest between %4 and %5 m (%6)"),
    // clang-format on
    QT_TRANSLATE_NOOP("core", "two heights are likely at %1 m: %2 m (%3 %) or %4 m (%5 %)"),
    QT_TRANSLATE_NOOP("core", "no live telemetry, the robot may have moved"),
    QT_TRANSLATE_NOOP("core", "the scene is unlike all training"),
    QT_TRANSLATE_NOOP("core", "the robot rolls, left and right ground differ"),
    QT_TRANSLATE_NOOP("core", "the flippers differ, left and right ground differ"),
    QT_TRANSLATE_NOOP("core", "STOP is latched: release it first"),
    QT_TRANSLATE_NOOP("core", "The link must be good for a second"),
    QT_TRANSLATE_NOOP("core", "commands can leave"),
    QT_TRANSLATE_NOOP("core", "no other console sends commands"),
    QT_TRANSLATE_NOOP("core", "STOP is not latched"),
    QT_TRANSLATE_NOOP("core", "the link is good"),
    QT_TRANSLATE_NOOP("core", "nobody else has armed the robot"),
    QT_TRANSLATE_NOOP("core", "CLEAR"),
    QT_TRANSLATE_NOOP("core", "BLOCKED"),
    QT_TRANSLATE_NOOP("core", "CANNOT TELL"),
    QT_TRANSLATE_NOOP("core", "ready"),
    QT_TRANSLATE_NOOP("core", "halting the robot"),
    QT_TRANSLATE_NOOP("core", "pressing the front flippers down"),
    QT_TRANSLATE_NOOP("core", "estimating the terrain"),
    QT_TRANSLATE_NOOP("core", "arm probe proposed"),
    QT_TRANSLATE_NOOP("core", "arm is probing"),
    QT_TRANSLATE_NOOP("core", "estimating again with the arm's height"),
    QT_TRANSLATE_NOOP("core", "estimate stands"),
    QT_TRANSLATE_NOOP("core", "STOPPED"),
    QT_TRANSLATE_NOOP("core", "exploration failed"),
    QT_TRANSLATE_NOOP("core", "following: nothing is explored"),
    QT_TRANSLATE_NOOP("core", "following: flippers go down"),
    QT_TRANSLATE_NOOP("core", "following: flippers pressed, estimating the terrain"),
    QT_TRANSLATE_NOOP("core", "following: flippers pressed, arm is probing"),
    QT_TRANSLATE_NOOP("core", "following: estimating again with the arm's height"),
    QT_TRANSLATE_NOOP("core", "following: estimate stands"),
    QT_TRANSLATE_NOOP("core", "following: the robot is stopped"),
    QT_TRANSLATE_NOOP("core", "following: no estimate"),
    QT_TRANSLATE_NOOP("core", "no failure"),
    QT_TRANSLATE_NOOP("core", "the robot did not halt in time"),
    QT_TRANSLATE_NOOP("core", "the flippers found nothing to press against in time"),
    QT_TRANSLATE_NOOP("core", "the estimate took too long"),
    QT_TRANSLATE_NOOP("core", "the estimate could not be computed"),
    QT_TRANSLATE_NOOP("core", "the arm did not finish in time"),
    QT_TRANSLATE_NOOP("core", "the robot refused the probe"),
    QT_TRANSLATE_NOOP("core", "the robot refused to press"),
    QT_TRANSLATE_NOOP("core", "the link to the robot was lost"),
    QT_TRANSLATE_NOOP("core", "the robot moved, so what it felt no longer holds"),
    QT_TRANSLATE_NOOP("core", "the approval was of another scene, settings or model"),
    QT_TRANSLATE_NOOP("core", "the robot is not armed"),
    QT_TRANSLATE_NOOP("core", "not armed yet"),
    QT_TRANSLATE_NOOP("core", "disarmed by the operator"),
    QT_TRANSLATE_NOOP("core", "the stop is latched"),
    QT_TRANSLATE_NOOP("core", "window or panel does not answer"),
    QT_TRANSLATE_NOOP("core", "somebody else sends this console's frames"),
    QT_TRANSLATE_NOOP("core", "the link is not good"),
    QT_TRANSLATE_NOOP("core", "the robot is armed, but not by this console"),
    QT_TRANSLATE_NOOP("core", "not confirmed in time"),
    QT_TRANSLATE_NOOP("core", "the robot did not arm in time"),
    QT_TRANSLATE_NOOP("core", "the robot has disarmed"),
    QT_TRANSLATE_NOOP("core", "the robot has begun anew"),
    QT_TRANSLATE_NOOP("core", "halted"),
    QT_TRANSLATE_NOOP("core", "driving"),
    QT_TRANSLATE_NOOP("core", "front flippers pressed to the ground"),
    QT_TRANSLATE_NOOP("core", "probing with the arm"),
    QT_TRANSLATE_NOOP("core", "stopped"),
    QT_TRANSLATE_NOOP("core", "nothing refused"),
    QT_TRANSLATE_NOOP("core", "the arm does not reach that bin"),
    QT_TRANSLATE_NOOP("core", "the robot finds no pose to rest in there"),
    QT_TRANSLATE_NOOP("core", "the command is not of this arming"),
    QT_TRANSLATE_NOOP("core", "the command is beyond the robot's limits"),
    QT_TRANSLATE_NOOP("core", "yes"),
    QT_TRANSLATE_NOOP("core", "no"),
    QT_TRANSLATE_NOOP("core", "none"),
    QT_TRANSLATE_NOOP("core", "not measured"),
    QT_TRANSLATE_NOOP("core", "wire broken"),
    QT_TRANSLATE_NOOP("core", "short circuit"),
    QT_TRANSLATE_NOOP("core", "saturated"),
    QT_TRANSLATE_NOOP("core", "may be sent"),
    QT_TRANSLATE_NOOP("core", "not a frame that a console sends"),
    QT_TRANSLATE_NOOP("core", "the frame is damaged"),
    QT_TRANSLATE_NOOP("core", "the link to the robot is not good"),
    QT_TRANSLATE_NOOP("core", "the robot does not answer: what arrives may be a recording"),
    QT_TRANSLATE_NOOP("core", "the robot has begun a new arming"),
    QT_TRANSLATE_NOOP("core", "the robot is not stopped"),
    QT_TRANSLATE_NOOP("core", "not armed"),
    QT_TRANSLATE_NOOP("core", "arming is not confirmed"),
    QT_TRANSLATE_NOOP("core", "an exploration is running"),
    QT_TRANSLATE_NOOP("core", "no exploration is running"),
    QT_TRANSLATE_NOOP("core", "the robot is busy"),
    QT_TRANSLATE_NOOP("core", "the front flippers are not pressed to the ground"),
    QT_TRANSLATE_NOOP("core", "the value is over its limit"),
    QT_TRANSLATE_NOOP("core", "nobody has approved the probe"),
    QT_TRANSLATE_NOOP("core", "the approval is too old"),
    QT_TRANSLATE_NOOP("core", "another bin was approved"),
    QT_TRANSLATE_NOOP("core",
                      "chains not converged: R-hat %1 (limit %2), effective draws %3 (limit %4)"),
    // NOLINTNEXTLINE(bugprone-suspicious-missing-comma)
    QT_TRANSLATE_NOOP("core", "chains not converged when time was out: R-hat %1 (limit %2), "
                              "effective draws %3 (limit %4)"),
    QT_TRANSLATE_NOOP("core",
                      "the model of bin %1 m is singular: %2 of its variance was added as noise"),
};

}  // namespace

QString words::sentence(std::string_view english)
{
    static const QRegularExpression kNumber(
        QStringLiteral("(?<![A-Za-z0-9])[+-]?[0-9]+(\\.[0-9]+)?(e[+-]?[0-9]+)?"));
    QString whole = text(english);
    QString pattern;
    QStringList numbers;
    qsizetype done = 0;
    for (auto found = kNumber.globalMatch(whole); found.hasNext();) {
        const QRegularExpressionMatch match = found.next();
        numbers << match.captured();
        pattern += whole.mid(done, match.capturedStart() - done)
                 + QStringLiteral("%%1").arg(numbers.size());
        done = match.capturedEnd();
    }
    pattern += whole.mid(done);
    const QString translated = QCoreApplication::translate("core", pattern.toUtf8().constData());
    if (translated == pattern) return whole;
    QString result;
    static const QRegularExpression kPlace(QStringLiteral("%([1-9])"));
    done = 0;
    for (auto found = kPlace.globalMatch(translated); found.hasNext();) {
        const QRegularExpressionMatch match = found.next();
        result += translated.mid(done, match.capturedStart() - done)
                + numbers.value(match.captured(1).toInt() - 1);
        done = match.capturedEnd();
    }
    return result + translated.mid(done);
}

}  // namespace terratact
