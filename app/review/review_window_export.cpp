#include <algorithm>

#include "app/pages/numbers_page.h"
#include "app/pages/terrain_page.h"
#include "app/pages/terrain_picture.h"
#include "app/review/export/review_export.h"
#include "app/review/export/review_export_dialog.h"
#include "app/review/review_timeline.h"
#include "app/review/review_window.h"
#include "widgets/terrain/readings/numbers_table.h"
#include "widgets/terrain/terrain_profile_view.h"

namespace terratact {

ExportViewState ReviewWindow::exportViewState() const
{
    const ReviewPlayer& p = player();
    ExportViewState viewState{.now = p.position(),
                              .first = timeline()->first(),
                              .last = timeline()->last(),
                              .isCursors = p.a() && p.b(),
                              .begin = p.begin(),
                              .end = p.end(),
                              .scene = moment_.estimate ? moment_.estimate->scene : 0};
    if (viewState.isCursors) {
        viewState.first = std::min(*p.a(), *p.b());
        viewState.last = std::max(*p.a(), *p.b());
    }
    return viewState;
}

void ReviewWindow::exportShown()
{
    if (!export_)
        export_ = new ReviewExportDialog(
            {.session = QString::fromStdString(session_.path()),
             .poll = [this] { return exportViewState(); },
             .dbc = [this] { return preferences_->current().dbc; },
             .savePicture =
                 [this](const QString& path) { return savePicture(*terrain_->terrain(), path); },
             .saveNumbers =
                 [this](const QString& path) {
                     numbers_->refresh(0.0);
                     return saveNumbers(moment_, *numbers_->table(), path);
                 }},
            this);
    export_->ask();
}

}  // namespace terratact
