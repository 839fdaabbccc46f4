// Tests what the plots show of a source that another thread fills.
#include "app/pages/plots_panel.h"

#include <gtest/gtest.h>

#include "app/shell/preferences/preference_store.h"
#include "widgets/signals/plot_values.h"

namespace terratact {
namespace {

/// A source whose last value comes between the first view and the next question for the version.
class FillingSource final : public PlotSource {
public:
    std::vector<PlotSignal> catalogue() const override { return {}; }
    void choose(const std::vector<std::string>& keys) override { first_ = keys.front(); }
    SeriesView view(const std::string& key, const PlotSpan&) override
    {
        SeriesView seen;
        seen.visible.count = count_;
        if (key == first_ && count_ == 1) {
            count_ = 2;
            ++version_;
        }
        return seen;
    }
    double begin() const override { return 0.0; }
    double end() const override { return 4.0; }
    std::uint64_t version() const override { return version_; }

private:
    std::string first_;
    std::uint64_t count_ = 1, version_ = 1;
};

TEST(PlotsPanel, showsValuesThatComeWhileItReads)
{
    FillingSource source;
    PreferenceStore preferences;
    PlotsPanel panel(source, preferences, PlotsPanel::Kind::Review);
    panel.refresh(1.0);
    ASSERT_EQ(panel.values()->text(0, PlotValues::Count), "1");
    panel.refresh(2.0);
    EXPECT_EQ(panel.values()->text(0, PlotValues::Count), "2");
}

}  // namespace
}  // namespace terratact
