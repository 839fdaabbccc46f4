#include "app/mission/text/method_text.h"

#include <QCoreApplication>
#include <QStringList>

#include "app/display/format.h"

namespace terratact {
namespace {

struct MethodText {
    Q_DECLARE_TR_FUNCTIONS(MethodText)
};

}  // namespace

QString methodUses(Method method)
{
    switch (method) {
    case Method::Pa: return MethodText::tr("uses pitch and flipper angles; Markov chains");
    case Method::Pac: return MethodText::tr("uses pitch, flipper angles and body; Markov chains");
    case Method::Pafc:
        return MethodText::tr("uses what pac uses, forces and currents; Markov chains");
    case Method::Pafac: return MethodText::tr("uses what pafc uses, and the arm; Markov chains");
    case Method::Clearance:
        return MethodText::tr("uses what pafc uses, and models the clearance; Markov chains");
    case Method::Joint:
        return MethodText::tr("uses pose, forces, currents and clearance; closed form");
    case Method::Local:
        return MethodText::tr("uses what joint uses, and the most similar scenes; closed form");
    case Method::Trail:
        return MethodText::tr("uses what local uses, and the way before; closed form");
    }
    return {};
}

QString methodLines(const std::vector<Method>& methods)
{
    QStringList lines;
    for (const Method method : methods)
        lines << QStringLiteral("%1: %2").arg(format::text(name(method)), methodUses(method));
    return lines.join(QLatin1Char('\n'));
}

}  // namespace terratact
