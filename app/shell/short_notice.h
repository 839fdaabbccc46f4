#pragma once

#include <QString>

class QLabel;

namespace terratact {

/// A banner over the whole width that says something for some seconds, on whichever page.  GUI thread only.
class ShortNotice {
public:
    static constexpr double kFor = 8.0;  ///< [s]

    explicit ShortNotice(QLabel& banner);  ///< which must outlive it

    /// now: [s] any monotonic clock.  What was said before gives way.
    void say(const QString& text, double now);
    /// To be called several times a second.  hasRoom: nothing that matters more stands in its place.
    void poll(double now, bool hasRoom);

private:
    QLabel& banner_;
    double until_ = 0.0;  ///< [s]
};

}  // namespace terratact
