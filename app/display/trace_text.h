#pragma once

#include <QString>

namespace terratact {

/// The texts of one frame.
struct TraceText {
    QString id, name, bytes, content;
};

}  // namespace terratact
