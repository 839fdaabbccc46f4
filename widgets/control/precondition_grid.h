#pragma once

#include <QGridLayout>
#include <QList>

#include "app/display/precondition.h"

namespace terratact {

/// Lines of preconditions: a mark and the reason of each. The mark, the tone and the spoken name state the level.
class PreconditionGrid : public QGridLayout {
    Q_OBJECT
public:
    PreconditionGrid();

    void setPreconditions(const QList<Precondition>& preconditions);

private:
    void addLine();

    QList<Precondition> shown_;
};

}  // namespace terratact
