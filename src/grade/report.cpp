#include "grade/report.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <utility>

#include "base/polygon.h"
#include "base/trig.h"

namespace ccmorse::grade {
namespace {

// Colours by role, light and dark; chosen so that they differ for the colour-blind, too.
constexpr const char* kStyle = R"(<style>
:root{color-scheme:light dark;--back:#f6f7f9;--card:#fff;--text:#1b1f24;--soft:#5b6570;--line:#d9dee4;
--good:#1a7f4b;--mid:#b26a00;--bad:#c0362c;--way:#0b62c4;--wall:#4a5159;--floor:#fff;--goal:#8a3ffc}
@media(prefers-color-scheme:dark){:root{--back:#14171a;--card:#1d2125;--text:#e7eaee;--soft:#9aa5b1;
--line:#363d45;--good:#4cc38a;--mid:#e0a33e;--bad:#ff7a6e;--way:#6cb2ff;--wall:#aab4bf;--floor:#23282d;
--goal:#c19bff}}
*{box-sizing:border-box}body{margin:0;background:var(--back);color:var(--text);
font:16px/1.5 system-ui,sans-serif}main{max-width:1080px;margin:0 auto;padding:32px 20px 64px}
h1{font-size:28px;margin:0 0 4px}h2{font-size:20px;margin:40px 0 12px}h3{font-size:17px;margin:0 0 8px}
p{margin:8px 0}.soft{color:var(--soft)}.card{background:var(--card);border:1px solid var(--line);
border-radius:12px;padding:20px;margin:16px 0}.top{display:flex;gap:28px;align-items:center;flex-wrap:wrap}
.score{font-size:52px;font-weight:700;line-height:1;font-variant-numeric:tabular-nums}
.badge{display:inline-block;border-radius:99px;padding:3px 12px;font-weight:600;border:2px solid}
.good{color:var(--good)}.mid{color:var(--mid)}.bad{color:var(--bad)}
.scroll{overflow-x:auto}table{border-collapse:collapse;width:100%;font-variant-numeric:tabular-nums}
th,td{text-align:left;padding:8px 12px 8px 0;border-top:1px solid var(--line);vertical-align:top}
th{color:var(--soft);font-weight:500;border-top:0}td.n,th.n{text-align:right;white-space:nowrap}
.bar{width:110px;height:10px;border-radius:5px;background:var(--line);overflow:hidden;margin-top:7px}
.bar i{display:block;height:100%;border-radius:5px;background:currentColor}
.run{display:grid;grid-template-columns:minmax(260px,400px) 1fr;gap:24px}
@media(max-width:760px){.run{grid-template-columns:1fr}}svg{width:100%;height:auto;display:block}
code,pre{font:13px/1.5 ui-monospace,monospace}pre{white-space:pre-wrap;overflow-wrap:anywhere;
background:var(--back);border:1px solid var(--line);border-radius:8px;padding:12px;margin:8px 0}
.key{display:flex;gap:16px;flex-wrap:wrap;font-size:13px;color:var(--soft);margin-top:8px}
.key i{display:inline-block;width:14px;height:10px;border-radius:3px;margin-right:5px}
.criteria th:nth-child(1){width:170px}.criteria th:nth-child(2){width:90px}
.criteria th:nth-child(3){width:110px}.criteria th:nth-child(4){width:130px}
h4{font-size:15px;font-weight:500;margin:16px 0 6px}
svg text{fill:var(--soft);font:11px system-ui,sans-serif}
</style>)";

const char* ClassOf(double share) { return share >= 0.8 ? "good" : share >= 0.5 ? "mid" : "bad"; }

// "0.25", "3", "12.3": as many digits as help.
std::string Number(double value) {
  if (!std::isfinite(value)) return "&#8734;";
  const double size = std::fabs(value);
  if (std::fabs(value - std::round(value)) < 5e-4) return fmt::format("{:.0f}", value);
  std::string text = fmt::format("{:.{}f}", value,
                                 size >= 100.0  ? 0
                                 : size >= 10.0 ? 1
                                 : size >= 1.0  ? 2
                                                : 3);
  if (text.find('.') != std::string::npos) {
    while (text.back() == '0') text.pop_back();
    if (text.back() == '.') text.pop_back();
  }
  return text;
}

std::string Head(const std::string& title) {
  return fmt::format(
      "<!doctype html>\n<html lang=\"en\"><head><meta charset=\"utf-8\">\n<meta name=\"viewport\" "
      "content=\"width=device-width,initial-scale=1\">\n<title>{}</title>\n{}</"
      "head>\n<body><main>\n",
      title, kStyle);
}

std::string Bar(double share) {
  return fmt::format("<div class=\"bar {}\"><i style=\"width:{:.0f}%\"></i></div>", ClassOf(share),
                     100.0 * std::clamp(share, 0.0, 1.0));
}

template <class Row>
std::string CriteriaTable(const std::vector<Row>& rows) {
  std::string out =
      "<div class=\"scroll\"><table class=\"criteria\"><tr><th>criterion</th><th "
      "class=\"n\">measured"
      "</th><th class=\"n\">points</th><th></th><th>what to know</th></tr>\n";
  for (const Row& row : rows) {
    const double share = row.points / row.weight;
    out += fmt::format(
        "<tr><td>{}<br><span class=\"soft\"><code>{}</code></span></td><td class=\"n\">{}</td><td "
        "class=\"n {}\"><b>{:.1f}</b> of {}</td><td>{}</td><td>{}</td></tr>\n",
        Escaped(row.name), row.measure, row.value ? Number(*row.value) : "&ndash;", ClassOf(share),
        row.points, Number(row.weight), Bar(share), Escaped(row.reason));
  }
  return out + "</table></div>\n";
}

// --- The drive from above: SVG in cm, y turned upwards.

std::string PointText(Vec2 point, double height) {
  return fmt::format("{:.1f},{:.1f} ", point.x * 100.0, (height - point.y) * 100.0);
}

std::string Polygon(std::span<const Vec2> corners, double height, const char* look) {
  std::string out = "<polygon points=\"";
  for (const Vec2& corner : corners) out += PointText(corner, height);
  return out + fmt::format("\" {}/>\n", look);
}

std::string Polyline(const std::vector<Vec2>& points, double height, const char* look) {
  std::string out = "<polyline points=\"";
  for (const Vec2& point : points) out += PointText(point, height);
  return out + fmt::format("\" fill=\"none\" stroke-linejoin=\"round\" {}/>\n", look);
}

std::string Disc(Vec2 at, double height, double radius, const std::string& look) {
  return fmt::format("<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"{}\" {}/>\n", at.x * 100.0,
                     (height - at.y) * 100.0, radius, look);
}

std::string FromAbove(const Rubric& rubric, const Judgement& judgement) {
  const scene::World& world = judgement.world;
  const double height = world.size_y;
  std::string out = fmt::format(
      "<svg viewBox=\"-2 -2 {:.1f} {:.1f}\" role=\"img\" aria-label=\"the drive seen from above\">"
      "<rect width=\"{:.1f}\" height=\"{:.1f}\" fill=\"var(--floor)\"/>\n",
      world.size_x * 100.0 + 4.0, height * 100.0 + 4.0, world.size_x * 100.0, height * 100.0);
  for (const scene::Box& box : world.boxes) {
    if (!box.raised) continue;
    out += Polygon(BoxCorners(box.pose, box.size_x, box.size_y), height, "fill=\"var(--wall)\"");
  }
  if (!rubric.reference.trajectory.empty()) {
    out += Polyline(rubric.reference.trajectory, height,
                    "stroke=\"var(--goal)\" stroke-width=\"1.6\" stroke-dasharray=\"4 3\"");
  }
  for (const auto& [robot, goals] : rubric.reference.goals) {
    for (const Vec2& goal : goals) {
      out += Disc(goal, height, 5.0, "fill=\"none\" stroke=\"var(--goal)\" stroke-width=\"1.6\"");
    }
  }
  if (judgement.path.size() > 1) {
    out += Polyline(judgement.path, height, "stroke=\"#e8830c\" stroke-width=\"2.2\"");
  }
  for (const RobotTrack& robot : judgement.robots) {
    if (robot.samples.empty()) continue;
    std::vector<Vec2> way;
    for (const Sample& sample : robot.samples) {
      const Vec2 at{sample.pose.x, sample.pose.y};
      if (way.empty() || std::hypot(at.x - way.back().x, at.y - way.back().y) > 0.005) {
        way.push_back(at);
      }
    }
    out += Polyline(way, height, "stroke=\"var(--way)\" stroke-width=\"1.6\"");
    bool before = false;
    for (const Sample& sample : robot.samples) {
      if (sample.touching && !before) {
        out += Disc({sample.pose.x, sample.pose.y}, height, 4.0,
                    "fill=\"none\" stroke=\"var(--bad)\" stroke-width=\"2\"");
      }
      before = sample.touching;
    }
    const Pose2& first = robot.samples.front().pose;
    const Pose2& last = robot.samples.back().pose;
    out += Disc({first.x, first.y}, height, 3.0, "fill=\"var(--good)\"");
    const std::array<Vec2, 3> arrow = {Transform(last, {0.10, 0.0}), Transform(last, {-0.07, 0.06}),
                                       Transform(last, {-0.07, -0.06})};
    out += Polygon(arrow, height, "fill=\"var(--way)\"");
  }
  if (judgement.route) {
    out += Disc(MiddleOf(judgement.route->start), height, 3.0, "fill=\"var(--good)\"");
    out += Disc(MiddleOf(judgement.route->goal), height, 4.5,
                "fill=\"none\" stroke=\"var(--goal)\" stroke-width=\"2.5\"");
  }
  out +=
      "</svg>\n<div class=\"key\"><span><i style=\"background:var(--good)\"></i>start</span>"
      "<span><i style=\"background:var(--way)\"></i>way driven</span>";
  if (judgement.path.size() > 1) {
    out += "<span><i style=\"background:#e8830c\"></i>path handed in</span>";
  }
  if (judgement.route || !rubric.reference.goals.empty() || !rubric.reference.trajectory.empty()) {
    out += "<span><i style=\"background:var(--goal)\"></i>goal</span>";
  }
  const bool touched = std::any_of(judgement.robots.begin(), judgement.robots.end(),
                                   [](const RobotTrack& robot) { return robot.contacts > 0; });
  if (touched) out += "<span><i style=\"background:var(--bad)\"></i>contact</span>";
  return out + "</div>\n";
}

// --- The map handed in: a shape for each kind of cell, of runs of cells in a row.

struct Shade {
  MapPicture::Kind kind;
  const char* color;
  const char* name;
};
constexpr std::array<Shade, 6> kShades = {
    {{MapPicture::kUnknown, "var(--line)", "unknown"},
     {MapPicture::kFree, "var(--floor)", "free"},
     {MapPicture::kWall, "var(--text)", "wall"},
     {MapPicture::kInventedWall, "#e8830c", "no wall is there"},
     {MapPicture::kMissedWall, "var(--bad)", "a wall is there"},
     {MapPicture::kNotSeen, "var(--goal)", "said, but not seen"}}};

std::string MapFromAbove(const MapPicture& map) {
  std::string out = fmt::format(
      "<svg viewBox=\"-1 -1 {} {}\" role=\"img\" shape-rendering=\"crispEdges\" "
      "aria-label=\"the map that was handed in\">\n",
      map.width + 2, map.height + 2);
  std::string key = "</svg>\n<div class=\"key\">";
  for (const Shade& shade : kShades) {
    std::string shape;
    for (int y = 0; y < map.height; ++y) {
      const auto* const row = map.cells.data() + static_cast<std::ptrdiff_t>(y) * map.width;
      for (int x = 0, end = 0; x < map.width; x = end) {
        for (end = x + 1; end < map.width && row[end] == row[x];) ++end;
        if (row[x] != shade.kind) continue;
        shape += fmt::format("M{} {}h{}v1H{}z", x, map.height - 1 - y, end - x, x);
      }
    }
    if (shape.empty()) continue;
    out += fmt::format("<path fill=\"{}\" d=\"{}\"/>\n", shade.color, shape);
    key +=
        fmt::format("<span><i style=\"background:{};border:1px solid var(--line)\"></i>{}</span>",
                    shade.color, shade.name);
  }
  return out + key + "</div>\n";
}

// --- A plot over time.

constexpr double kPlotWidth = 560.0;
constexpr double kPlotHeight = 120.0;
constexpr double kPlotLeft = 40.0;
constexpr double kPlotBottom = 20.0;
constexpr int kMostPoints = 500;

std::string Plot(const std::vector<Sample>& samples, const char* title, double top,
                 const std::function<double(const Sample&)>& value, bool lowest) {
  const double end = std::max(samples.back().time, 1e-3);
  const double inner_width = kPlotWidth - kPlotLeft - 8.0;
  const double inner_height = kPlotHeight - kPlotBottom - 22.0;
  const auto x_of = [&](double time) { return kPlotLeft + inner_width * time / end; };
  const auto y_of = [&](double number) {
    return 22.0 + inner_height * (1.0 - std::clamp(number / top, 0.0, 1.0));
  };
  std::string out = fmt::format(
      "<svg viewBox=\"0 0 {} {}\" role=\"img\" aria-label=\"{}\"><text x=\"0\" "
      "y=\"12\">{}</text>\n",
      kPlotWidth, kPlotHeight, title, title);
  for (const double level : {0.0, top / 2.0, top}) {
    out += fmt::format(
        "<line x1=\"{0}\" x2=\"{1}\" y1=\"{2:.1f}\" y2=\"{2:.1f}\" stroke=\"var(--line)\"/><text "
        "x=\"{3}\" y=\"{4:.1f}\" text-anchor=\"end\">{5}</text>\n",
        kPlotLeft, kPlotLeft + inner_width, y_of(level), kPlotLeft - 5.0, y_of(level) + 4.0,
        Number(level));
  }
  for (const double share : {0.0, 0.5, 1.0}) {
    out += fmt::format("<text x=\"{:.1f}\" y=\"{}\" text-anchor=\"{}\">{} s</text>\n",
                       x_of(end * share), kPlotHeight - 4.0,
                       share == 0.0   ? "start"
                       : share == 1.0 ? "end"
                                      : "middle",
                       Number(std::round(end * share * 10.0) / 10.0));
  }
  // Of many samples the extreme one of each group, so that nothing short is lost.
  const std::size_t group = samples.size() / kMostPoints + 1;
  out += "<polyline fill=\"none\" stroke=\"var(--way)\" stroke-width=\"1.5\" points=\"";
  for (std::size_t i = 0; i < samples.size(); i += group) {
    double extreme = value(samples[i]);
    for (std::size_t k = i; k < std::min(i + group, samples.size()); ++k) {
      extreme =
          lowest ? std::min(extreme, value(samples[k])) : std::max(extreme, value(samples[k]));
    }
    out += fmt::format("{:.1f},{:.1f} ", x_of(samples[i].time), y_of(extreme));
  }
  return out + "\"/></svg>\n";
}

std::string RunCard(const Rubric& rubric, const RunReport& run) {
  const double share = run.score() / 100.0;
  std::string out = fmt::format(
      "<section class=\"card\"><h3>World {} <span class=\"{}\">&middot; {:.1f} "
      "points</span></h3>\n",
      run.seed, ClassOf(share), run.score());
  if (!run.failure.empty()) {
    out += fmt::format("<p class=\"bad\"><b>Counts nothing:</b> {}</p>\n", Escaped(run.failure));
  }
  if (run.judgement) {
    const Judgement& judged = *run.judgement;
    out += "<div class=\"run\"><div>" + FromAbove(rubric, judged);
    if (judged.map) out += "<h4>The map handed in</h4>\n" + MapFromAbove(*judged.map);
    out += "</div><div>";
    for (const RobotTrack& robot : judged.robots) {
      if (robot.samples.size() < 2) continue;
      const std::string of = judged.robots.size() > 1 ? ", " + Escaped(robot.name) : "";
      double fastest = 0.1;
      for (const Sample& sample : robot.samples) fastest = std::max(fastest, sample.speed);
      out += Plot(
          robot.samples, ("speed, m/s" + of).c_str(), std::ceil(fastest * 10.0) / 10.0,
          [](const Sample& sample) { return sample.speed; }, false);
      out += Plot(
          robot.samples, ("from the robot's middle to the nearest wall, m" + of).c_str(), 1.0,
          [](const Sample& sample) { return sample.nearest; }, true);
      out += fmt::format(
          "<p class=\"soft\">{:.1f} s simulated, {:.2f} m driven, {} contact{}</p>\n",
          judged.seconds, robot.distance, robot.contacts, robot.contacts == 1 ? "" : "s");
    }
    if (judged.robots.empty() || judged.robots[0].samples.size() < 2) {
      out += "<p class=\"soft\">No simulated time went by.</p>\n";
    }
    out += "</div></div>\n";
    if (run.failure.empty()) out += CriteriaTable(judged.criteria);
  }
  if (!run.note.empty()) out += fmt::format("<p class=\"soft\">{}</p>\n", Escaped(run.note));
  if (run.cpu_s > 0.0) {
    out += fmt::format(
        "<p class=\"soft\">The program took {:.2f} s of processor time and {:.0f} MB "
        "of memory.</p>\n",
        run.cpu_s, run.memory_mb);
  }
  if (!run.record.empty()) {
    out += fmt::format("<p class=\"soft\">See it again:</p><pre>ccmorse replay {}</pre>\n",
                       Escaped(run.record));
  }
  return out + "</section>\n";
}

std::string Verdict(const Rubric& rubric, double score) {
  return score >= rubric.pass ? "passed" : "not passed";
}

void Sort(std::vector<ClassEntry>& entries) {
  std::sort(entries.begin(), entries.end(), [](const ClassEntry& a, const ClassEntry& b) {
    return a.score != b.score ? a.score > b.score : a.submission < b.submission;
  });
}

// RFC 4180; what a spreadsheet would take for a formula gets an apostrophe in front.
std::string CsvCell(const std::string& text) {
  std::string cell = "\"";
  if (!text.empty() && std::string("=+-@").find(text[0]) != std::string::npos) cell += '\'';
  for (const char c : text) {
    if (c == '"') cell += '"';
    cell += c == '\n' || c == '\r' ? ' ' : c;
  }
  return cell + '"';
}

}  // namespace

std::string Escaped(const std::string& text) {
  std::string out;
  for (const char c : text) {
    switch (c) {
      case '&':
        out += "&amp;";
        break;
      case '<':
        out += "&lt;";
        break;
      case '>':
        out += "&gt;";
        break;
      case '"':
        out += "&quot;";
        break;
      default:
        // Control characters have no place on a page, nor has what is not ASCII where it may be
        // half a character.
        out += static_cast<unsigned char>(c) < 32 && c != '\n' && c != '\t' ? '?' : c;
    }
  }
  return out;
}

double Grading::score() const {
  if (runs.empty()) return 0.0;
  double sum = 0.0;
  for (const RunReport& run : runs) sum += run.score();
  return sum / static_cast<double>(runs.size());
}

std::vector<CriterionMean> Means(const Rubric& rubric, const Grading& grading) {
  std::vector<CriterionMean> means;
  for (std::size_t i = 0; i < rubric.criteria.size(); ++i) {
    const Criterion& criterion = rubric.criteria[i];
    CriterionMean mean{criterion.name, criterion.measure, criterion.weight, 0.0, {}, {}};
    double values = 0.0;
    int count = 0;
    double fewest = criterion.weight;
    for (const RunReport& run : grading.runs) {
      double points = 0.0;
      std::string reason = run.failure;
      if (run.failure.empty() && run.judgement) {
        const CriterionResult& result = run.judgement->criteria[i];
        points = result.points;
        reason = result.reason;
        if (result.value) {
          values += *result.value;
          ++count;
        }
      }
      mean.points += points / static_cast<double>(grading.runs.size());
      if (points < fewest) {
        fewest = points;
        mean.reason = reason;
      }
    }
    if (grading.runs.empty()) mean.reason = grading.build_failure;
    if (count > 0) mean.value = values / count;
    means.push_back(std::move(mean));
  }
  return means;
}

Json GradingJson(const Rubric& rubric, const Grading& grading) {
  const auto criteria_json = [](const auto& rows) {
    Json::Array list;
    for (const auto& row : rows) {
      list.emplace_back(Json::Object{{"name", row.name},
                                     {"measure", row.measure},
                                     {"weight", row.weight},
                                     {"points", row.points},
                                     {"value", row.value ? Json(*row.value) : Json()},
                                     {"reason", row.reason}});
    }
    return Json(std::move(list));
  };
  Json::Array runs;
  for (const RunReport& run : grading.runs) {
    Json entry(Json::Object{{"seed", static_cast<std::int64_t>(run.seed)},
                            {"score", run.score()},
                            {"failure", run.failure},
                            {"note", run.note}});
    if (run.judgement) {
      entry.Set("seconds", run.judgement->seconds);
      entry.Set("hash", fmt::format("{:016x}", run.judgement->hash));
      entry.Set("criteria", criteria_json(run.judgement->criteria));
    }
    if (!run.record.empty()) entry.Set("record", run.record);
    runs.push_back(std::move(entry));
  }
  return Json(Json::Object{{"task", rubric.task},
                           {"submission", grading.submission},
                           {"score", grading.score()},
                           {"pass", rubric.pass},
                           {"passed", grading.score() >= rubric.pass},
                           {"sandbox", grading.sandboxed},
                           {"build_failure", grading.build_failure},
                           {"build_output", grading.build_output},
                           {"criteria", criteria_json(Means(rubric, grading))},
                           {"runs", std::move(runs)}});
}

std::string GradingTable(const Rubric& rubric, const Grading& grading) {
  std::string out = fmt::format("{}: {}\n", rubric.title, grading.submission);
  if (!grading.sandboxed) out += "without sandbox: the program could do whatever you can\n";
  if (!grading.build_failure.empty()) {
    out += fmt::format("not built: {}\n{}\n", grading.build_failure, grading.build_output);
  }
  out += fmt::format("\n{:<24} {:>10} {:>14}   {}\n", "criterion", "measured", "points",
                     "what to know");
  for (const CriterionMean& mean : Means(rubric, grading)) {
    out += fmt::format("{:<24} {:>10} {:>6.1f} of {:>4.0f}   {}\n", mean.name,
                       mean.value ? fmt::format("{:.3g}", *mean.value) : "-", mean.points,
                       mean.weight, mean.reason);
  }
  for (const RunReport& run : grading.runs) {
    out += fmt::format("world {:<18} {:>10} {:>6.1f} of  100   {}\n", run.seed, "", run.score(),
                       run.failure.empty() ? run.note : run.failure);
  }
  return out + fmt::format("\nscore {:.1f} of 100, {} ({} is the pass mark)\n", grading.score(),
                           Verdict(rubric, grading.score()), rubric.pass);
}

std::string GradingPage(const Rubric& rubric, const Grading& grading) {
  const double score = grading.score();
  std::string out = Head(Escaped(grading.submission) + " - " + Escaped(rubric.title));
  out += fmt::format(
      "<h1>{}</h1><p class=\"soft\">{}</p>\n<div class=\"card top\"><div class=\"score {}\">{:.1f}"
      "</div><div><span class=\"badge {}\">{}</span><p class=\"soft\">of 100 points; {} pass. Mean "
      "of {} world{}.</p></div></div>\n",
      Escaped(rubric.title), Escaped(grading.submission), ClassOf(score / 100.0), score,
      score >= rubric.pass ? "good" : "bad", Verdict(rubric, score), Number(rubric.pass),
      grading.runs.size(), grading.runs.size() == 1 ? "" : "s");
  if (!grading.sandboxed) {
    out +=
        "<p class=\"card bad\"><b>No sandbox:</b> the program ran unprotected and could do "
        "whatever the grader can, so this result is only worth what its author is trusted.</p>\n";
  }
  if (!grading.build_failure.empty()) {
    out += fmt::format(
        "<div class=\"card\"><h3 class=\"bad\">Not built</h3><p>{}</p><pre>{}</pre></div>\n",
        Escaped(grading.build_failure), Escaped(grading.build_output));
  }
  out +=
      "<h2>Criteria</h2><div class=\"card\">" + CriteriaTable(Means(rubric, grading)) + "</div>\n";
  if (!grading.runs.empty()) out += "<h2>Worlds</h2>\n";
  for (const RunReport& run : grading.runs) out += RunCard(rubric, run);
  out +=
      "<p class=\"soft\">Judged from the simulator's records, not from what the program says. "
      "How each measure is defined: docs/grading.md.</p>\n";
  return out + "</main></body></html>\n";
}

std::string ClassCsv(const Rubric& rubric, std::vector<ClassEntry> entries) {
  Sort(entries);
  std::string out = "place,submission,score,passed";
  for (const Criterion& criterion : rubric.criteria) out += "," + CsvCell(criterion.name);
  out += ",problem\n";
  int place = 0;
  for (std::size_t i = 0; i < entries.size(); ++i) {
    const ClassEntry& entry = entries[i];
    if (i == 0 || entry.score < entries[i - 1].score) place = static_cast<int>(i) + 1;
    out += fmt::format("{},{},{:.2f},{}", place, CsvCell(entry.submission), entry.score,
                       entry.passed ? "yes" : "no");
    for (std::size_t k = 0; k < rubric.criteria.size(); ++k) {
      out += fmt::format(",{:.2f}", k < entry.points.size() ? entry.points[k] : 0.0);
    }
    out += "," + CsvCell(entry.problem) + "\n";
  }
  return out;
}

std::string ClassPage(const Rubric& rubric, std::vector<ClassEntry> entries) {
  Sort(entries);
  const auto passed = std::count_if(entries.begin(), entries.end(),
                                    [](const ClassEntry& entry) { return entry.passed; });
  std::string out = Head(Escaped(rubric.title) + " - class");
  out += fmt::format(
      "<h1>{}</h1><p class=\"soft\">{} submissions, {} passed ({} points are needed)</p>\n"
      "<div class=\"card scroll\"><table><tr><th class=\"n\">#</th><th>submission</th><th "
      "class=\"n\">score</th><th></th>",
      Escaped(rubric.title), entries.size(), passed, Number(rubric.pass));
  for (const Criterion& criterion : rubric.criteria) {
    out += fmt::format("<th class=\"n\">{}<br>{}</th>", Escaped(criterion.name),
                       Number(criterion.weight));
  }
  out += "<th>problem</th></tr>\n";
  int place = 0;
  for (std::size_t i = 0; i < entries.size(); ++i) {
    const ClassEntry& entry = entries[i];
    if (i == 0 || entry.score < entries[i - 1].score) place = static_cast<int>(i) + 1;
    // The reports lie beside the table, one a submission.
    std::string link;
    for (const char c : entry.submission) {
      const bool plain =
          std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '-' || c == '_' || c == '.';
      link += plain ? std::string(1, c) : fmt::format("%{:02X}", static_cast<unsigned char>(c));
    }
    out += fmt::format(
        "<tr><td class=\"n\">{}</td><td><a href=\"{}/report.html\">{}</a></td><td class=\"n "
        "{}\"><b>{:.1f}</b></td><td>{}</td>",
        place, link, Escaped(entry.submission), entry.passed ? "good" : "bad", entry.score,
        Bar(entry.score / 100.0));
    for (std::size_t k = 0; k < rubric.criteria.size(); ++k) {
      out += fmt::format("<td class=\"n\">{:.1f}</td>",
                         k < entry.points.size() ? entry.points[k] : 0.0);
    }
    out += fmt::format("<td>{}</td></tr>\n", Escaped(entry.problem));
  }
  return out + "</table></div></main></body></html>\n";
}

}  // namespace ccmorse::grade
