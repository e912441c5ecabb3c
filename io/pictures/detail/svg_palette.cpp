#include <taut/io/pictures/detail/svg_palette.h>

namespace taut::detail {

namespace {

constexpr std::string_view kPalette = R"(
.taut .page{fill:#f7f6f2}
.taut .start{fill:#12965f;stroke:#12965f}
.taut .goal{fill:#7a3fd4;stroke:#7a3fd4}
.taut .target{stroke:#7a3fd4}
.taut .rooms{fill:#7a3fd4;fill-opacity:.14}
.taut .rim{stroke:#fff;fill:none}
.taut .path .line,.taut .forward{stroke:#ee5a10}
.taut .path .casing{stroke:#fff}
.taut .backward{stroke:#00838f}
.taut .runner{fill:#ee5a10;stroke:#fff;stroke-width:2}
.taut .solid{fill:#ccd2dc;fill-rule:evenodd}
.taut .free{fill:#fff;fill-rule:evenodd}
.taut .obstacle{fill:#4b5668}
.taut .walls{stroke:#2c3440}
.taut .walls .bar{stroke:#4b5668}
.taut .walls .area{fill:#4b5668;fill-rule:evenodd;stroke:none}
.taut .views{fill:#e8a713;fill-opacity:.13}
.taut .frontier{stroke:#c98a06;fill:none}
.taut .separation{stroke:#d3245e}
.taut .gates{stroke:#0b7fc1}
.taut .roadmap{stroke:#8fb6dc}
.taut .milestones{stroke:#3f7fbf}
.taut .discs{fill:#ee5a10;fill-opacity:.16;stroke:#ee5a10;stroke-width:1.5}
.taut .openings{stroke:#b9bfca}
.taut .guides,.taut .moves{fill:none;stroke:#7a8494;stroke-width:1.5;stroke-dasharray:6 4}
.taut .contours{fill:none;stroke:#5b8fd1;stroke-width:0.8}
.taut .grid{stroke:#d5d8de;fill:none}
.taut .ruler{stroke:#2c3440;fill:none;stroke-width:1.5}
.taut .sample{fill:none;stroke-width:3;stroke-linecap:round}
.taut text{fill:#2c3440;font:15px system-ui,'Segoe UI',Roboto,Helvetica,Arial,sans-serif}
.taut .title{font-size:19px;font-weight:600}
.taut .facts{fill:#5a6474}
.taut .labels{fill:#2c3440}
.taut .labels text,.taut text.labels{font-weight:bold}
.taut .labels text{stroke:#fff;stroke-width:3;paint-order:stroke;stroke-linejoin:round}
@media (prefers-color-scheme:dark){
.taut .page{fill:#12161d}
.taut .start{fill:#35c98c;stroke:#35c98c}
.taut .goal{fill:#b48cff;stroke:#b48cff}
.taut .target{stroke:#b48cff}
.taut .rooms{fill:#b48cff;fill-opacity:.2}
.taut .rim{stroke:#12161d}
.taut .path .line,.taut .forward{stroke:#ff8340}
.taut .path .casing{stroke:#12161d}
.taut .backward{stroke:#4dd0e1}
.taut .runner{fill:#ff8340;stroke:#12161d}
.taut .solid{fill:#3c4656}
.taut .free{fill:#1d2430}
.taut .obstacle{fill:#8e9aad}
.taut .walls{stroke:#d4dbe6}
.taut .walls .bar{stroke:#8e9aad}
.taut .walls .area{fill:#8e9aad}
.taut .views{fill:#ffd166;fill-opacity:.13}
.taut .frontier{stroke:#ffc83d}
.taut .separation{stroke:#ff5c8d}
.taut .gates{stroke:#4cc2ff}
.taut .roadmap{stroke:#47749f}
.taut .milestones{stroke:#7db4ea}
.taut .discs{fill:#ff8340;stroke:#ff8340}
.taut .openings{stroke:#566274}
.taut .guides,.taut .moves{stroke:#8e98a8}
.taut .contours{stroke:#4a76ad}
.taut .grid{stroke:#3c4656}
.taut .ruler{stroke:#e5e9f0}
.taut text{fill:#e5e9f0}
.taut .facts{fill:#a4aebd}
.taut .labels{fill:#e5e9f0}
.taut .labels text{stroke:#12161d}
}
)";

}  // namespace

std::string_view palette() { return kPalette; }

}  // namespace taut::detail
