#pragma once

#include <QString>

class QLabel;

namespace terratact {

/// A banner over the full width that shows a text for some seconds on every page. GUI thread only.
class ShortNotice {
public:
    static constexpr double kFor = 8.0;  ///< [s]

    explicit ShortNotice(QLabel& banner);  ///< the banner must outlive the notice

    /// Shows a text instead of any earlier one. now: any monotonic clock [s].
    void show(const QString& text, double now);
    /// Shows why a command had no effect.
    void showRefusal(const QString& text, double now);
    void endRefusal();  ///< the reason no longer holds; another text stays
    /// Call several times a second. hasRoom: no banner with priority is shown.
    void poll(double now, bool hasRoom);

private:
    QLabel& banner_;
    double until_ = 0.0;  ///< [s]
    bool isRefusal_ = false;
};

}  // namespace terratact
