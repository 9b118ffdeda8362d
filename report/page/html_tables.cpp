#include "report/page/html_tables.hpp"

#include <array>

#include "report/figures/text_format.hpp"

namespace farrier::report {
namespace {

std::string cell(const std::string& content, const char* css_class = nullptr) {
  return (css_class == nullptr ? "<td>" : "<td class=\"" + std::string(css_class) + "\">") + content + "</td>";
}

std::string number_cell(const Figure* figure) {
  if (figure == nullptr) {
    return cell("");
  }
  const std::string bound = figure->bound ? "<small> " + escape_html(bound_text(*figure)) + "</small>" : "";
  return cell(short_number(figure->value) + bound, figure->holds() ? "number" : "number fails");
}

std::string property(const char* name, const std::string& value) {
  return std::string("<tr><th>") + name + "</th>" + cell(escape_html(value)) + "</tr>\n";
}

struct Column {
  const char* title;
  const char* figure;
};
std::string image_tag(std::string_view path, std::string_view what) {
  return "<img src=\"" + escape_html(path) + "\" alt=\"" + escape_html(what) + "\">";
}

constexpr std::array kPageColumns{Column{"updates", "updates"},
                                  Column{"stance NRMSE", "stance_nrmse"},
                                  Column{"with swing design", "swing_design_stance_nrmse"},
                                  Column{"swing NRMSE", "swing_nrmse"},
                                  Column{"with swing design", "swing_design_swing_nrmse"},
                                  Column{"missed ticks", "missed_ticks"},
                                  Column{"travel / rad", "travel_rad"},
                                  Column{"spectral radius, stance", "stance_spectral_radius"},
                                  Column{"spectral radius, swing", "swing_spectral_radius"}};

}  // namespace

std::string escape_html(std::string_view text) {
  std::string escaped;
  for (const char c : text) {
    switch (c) {
      case '&':
        escaped += "&amp;";
        break;
      case '<':
        escaped += "&lt;";
        break;
      case '>':
        escaped += "&gt;";
        break;
      case '"':
        escaped += "&quot;";
        break;
      case '\'':
        escaped += "&#39;";
        break;
      default:
        escaped += c;
    }
  }
  return escaped;
}

std::string image_html(std::string_view path, std::string_view what) {
  return path.empty() ? "" : image_tag(path, what) + "\n";
}

std::string captioned_image_html(std::string_view path, std::string_view caption) {
  return path.empty() ? ""
                      : "<figure>" + image_tag(path, caption) + "<figcaption>" + escape_html(caption) +
                            "</figcaption></figure>\n";
}

std::string joint_table_html(const Figures& figures) {
  std::string html = "<table><thead><tr><th>joint</th>";
  for (const Column& column : kPageColumns) {
    html += std::string("<th>") + column.title + "</th>";
  }
  html += "</tr></thead>\n<tbody>\n";
  for (const std::string& joint : joints_of(figures)) {
    const std::string name = escape_html(joint);
    html += "<tr><th><a href=\"#" + name + "\">" + name + "</a></th>";
    for (const Column& column : kPageColumns) {
      html += number_cell(figures.find("trot." + joint + "." + column.figure));
    }
    html += "</tr>\n";
  }
  return html + "</tbody></table>\n";
}

std::string figures_table_html(const Figures& figures) {
  std::string html =
      "<table><thead><tr><th>figure</th><th>value</th><th>unit</th><th>bound</th><th>meaning</th></tr></thead>\n"
      "<tbody>\n";
  for (const Figure& figure : figures.all()) {
    if (figure.name.starts_with("trot.packets.")) {
      continue;
    }
    html += "<tr>" + cell("<code>" + escape_html(figure.name) + "</code>") +
            cell(short_number(figure.value), figure.holds() ? "number" : "number fails") + cell(figure.spec->unit) +
            cell(escape_html(bound_text(figure))) + cell(escape_html(figure.spec->sentence), "meaning") + "</tr>\n";
  }
  return html + "</tbody></table>\n";
}

std::string decisions_html(const RunInfo& run) {
  if (run.decisions.empty()) {
    return {};
  }
  std::string html =
      "<h2>Decisions about gains</h2>\n<details><summary>All of them: " + std::to_string(run.decisions.size()) +
      "</summary>\n<table><thead><tr><th>tick</th><th>joint</th><th>phase</th><th>verdict</th>"
      "<th>generation</th><th>pole distance</th><th>pole spread</th><th>validity</th><th>excitation</th>"
      "<th>radius on the estimate</th><th>on the stored model</th><th>disk margin</th><th>delay margin, s</th>"
      "<th>dwell ticks</th></tr></thead>\n<tbody>\n";
  for (const DecisionInfo& info : run.decisions) {
    const signals::JointUpdateDecision& decision = info.decision;
    const auto number = [](double value) { return cell(short_number(value), "number"); };
    html += "<tr>" + cell(std::to_string(decision.tick), "number") + cell(escape_html(info.joint)) +
            cell(signals::to_string(decision.phase)) + cell(signals::to_string(decision.verdict)) +
            cell(std::to_string(decision.generation), "number") + number(decision.pole_distance) +
            number(decision.pole_spread) + number(decision.validity) + number(decision.excitation) +
            number(decision.estimated_radius) + number(decision.stored_radius) + number(decision.disk_margin) +
            number(decision.delay_margin_s) + cell(std::to_string(decision.dwell_ticks), "number") + "</tr>\n";
  }
  return html + "</tbody></table>\n</details>\n";
}

std::string processes_table_html(const RunInfo& run) {
  std::string html =
      "<table><thead><tr><th>process</th><th>pid</th><th>DDS</th><th>missed periods</th><th>samples</th></tr>"
      "</thead>\n<tbody>\n";
  for (const ProcessInfo& process : run.processes) {
    std::string samples;
    for (const std::string& text : topic_texts(process)) {
      samples += (samples.empty() ? "" : "<br>") + escape_html(text);
    }
    html += "<tr><th>" + escape_html(process.name) + "</th>" + cell(std::to_string(process.pid), "number") +
            cell(escape_html(process.vendor)) + cell(std::to_string(process.missed_periods), "number") + cell(samples) +
            "</tr>\n";
  }
  return html + "</tbody></table>\n";
}

std::string run_table_html(const RunInfo& run) {
  constexpr double kGiB = 1024.0 * 1024.0 * 1024.0;
  return "<table><tbody>\n" + property("version", run.version) + property("git revision", run.git_revision) +
         property("seed", std::to_string(run.seed)) + property("configuration hash", run.configuration_hash) +
         property("processor", run.machine.cpu_model + ", " + std::to_string(run.machine.cores) + " cores") +
         property("kernel", run.machine.kernel) +
         property("memory", short_number(static_cast<double>(run.machine.memory_bytes) / kGiB) + " GiB") +
         "</tbody></table>\n";
}

}  // namespace farrier::report
